package tellosimulator.scenery.room;

import tellosimulator.scenery.Texture;

/**
 * An image to be hung up.
 *
 * @param texture the image, stretched to a size that textures have
 * @param ratio of its height to its width
 */
public record Picture(Texture texture, double ratio) {}
