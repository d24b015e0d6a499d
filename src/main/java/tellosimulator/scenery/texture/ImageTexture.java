package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.Texture;

/**
 * An image file as a texture.
 *
 * @param texture the image, resampled to powers of two
 * @param aspectRatio of the image: height by width
 */
public record ImageTexture(Texture texture, double aspectRatio) {}
