/**
 * What a drone's camera sees. {@link tellosimulator.video.camera.FrameSource} is where pictures
 * come from. {@link tellosimulator.video.camera.SoftwareCamera} draws them without display,
 * graphics card or toolkit; the same geometry ({@link tellosimulator.video.camera.DroneOptics})
 * serves the window.
 *
 * <p>A picture is drawn by one thread: each drone's video has its own, and other drones need the
 * other processors. All cameras share the textures and meshes that are made ready for drawing
 * ({@link tellosimulator.video.camera.Props}). Inner loops work on plain arrays that are used again
 * for each picture, because a picture has 700,000 pixels and some milliseconds. Encoding is not the
 * job of this package.
 */
package tellosimulator.video.camera;
