/**
 * Renders the images of the drones' cameras. {@link tellosimulator.video.camera.FrameSource}
 * provides frames; {@link tellosimulator.video.camera.SoftwareCamera} is a software rasteriser,
 * which needs no display, graphics card or toolkit. {@link tellosimulator.video.camera.DroneOptics}
 * describes the cameras, and is also used by the window. The terms are those of 3D rendering;
 * {@code docs/glossary.md} lists them.
 *
 * <p>Each frame is rendered by a single thread. Each drone's video has its own thread, so several
 * drones use several processors. All cameras share one {@link
 * tellosimulator.video.camera.RenderCache}. Inner loops work on plain arrays that are reused for
 * each frame, because a frame has 700,000 pixels and must be rendered within a few milliseconds.
 * Encoding is not the job of this package.
 */
package tellosimulator.video.camera;
