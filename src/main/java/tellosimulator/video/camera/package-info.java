/**
 * What a drone's camera sees. {@link tellosimulator.video.camera.FrameSource} is where pictures
 * come from; the software camera is one that needs neither display nor graphics card. The same
 * geometry serves the window. Encoding is not its job.
 */
package tellosimulator.video.camera;
