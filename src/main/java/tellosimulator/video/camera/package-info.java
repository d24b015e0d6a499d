/**
 * The drones' cameras. {@link tellosimulator.video.camera.FrameSource} is where frames come from;
 * {@link tellosimulator.video.camera.SoftwareCamera} is a software rasteriser, which needs no
 * display, graphics card or toolkit; {@link tellosimulator.video.camera.DroneOptics} describes the
 * cameras and serves the window too. The terms are those of 3D rendering; {@code docs/glossary.md}
 * lists them.
 *
 * <p>A frame is rendered by one thread: each drone's video has its own, and other drones need the
 * other processors. All cameras share one {@link tellosimulator.video.camera.RenderCache}. Inner
 * loops work on plain arrays that are reused for each frame, because a frame has 700,000 pixels and
 * some milliseconds. Encoding is not the job of this package.
 */
package tellosimulator.video.camera;
