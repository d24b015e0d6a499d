package tellosimulator.scenery.mesh;

/**
 * The appearance of a surface.
 *
 * @param texture colours and transparency of the surface
 * @param shading effect of light, transparency and depth on the surface
 */
public record Material(Texture texture, Shading shading) {}
