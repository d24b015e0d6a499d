package tellosimulator.scenery.mesh;

/**
 * What a surface looks like.
 *
 * @param texture its colours and its transparency
 * @param shading how light, transparency and depth act on it
 */
public record Material(Texture texture, Shading shading) {}
