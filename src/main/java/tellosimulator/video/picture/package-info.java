/**
 * A picture on its way from the camera to the encoder. The camera fills a {@link
 * tellosimulator.video.picture.Picture}, and the encoder reads it on the same thread.
 */
package tellosimulator.video.picture;
