package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.Texture;

/**
 * An image file that has been converted to a texture.
 *
 * @param texture the image, resampled to powers of two
 * @param aspectRatio height of the original image divided by its width
 */
public record ImageTexture(Texture texture, double aspectRatio) {}
