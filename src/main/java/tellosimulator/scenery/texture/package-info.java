/**
 * Sources of textures: {@link tellosimulator.scenery.texture.ImageFile} reads image files of
 * people, {@link tellosimulator.scenery.texture.PngResource} those that come with the program,
 * {@link tellosimulator.scenery.texture.ProceduralTexture} computes texels, and {@link
 * tellosimulator.scenery.texture.AlphaMask} draws antialiased strokes, polygons and numbers. The
 * package imports only {@code scenery.mesh}, and needs neither fonts nor a display. What is drawn
 * is not its job.
 */
package tellosimulator.scenery.texture;
