/**
 * A picture on its way from camera to encoder. {@link tellosimulator.video.picture.Picture} is
 * filled by one and read by the other, on one thread.
 */
package tellosimulator.video.picture;
