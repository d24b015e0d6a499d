/**
 * Sources of textures. {@link tellosimulator.scenery.texture.ImageFile} reads image files, {@link
 * tellosimulator.scenery.texture.ProceduralTexture} computes texels, and {@link
 * tellosimulator.scenery.texture.AlphaMask} draws antialiased strokes, polygons and numbers. The
 * package imports only {@code scenery.mesh}, and needs neither fonts nor a display. The design of
 * particular textures is not its job.
 */
package tellosimulator.scenery.texture;
