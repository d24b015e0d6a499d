/**
 * The drones' video in the window: where it is shown, kept, and taken from the window's own scene.
 *
 * <p>{@link tellosimulator.view.video.WindowVideo} holds the streams of all drones; {@link
 * tellosimulator.view.video.VideoView} shows one. Pictures come from video threads, which never
 * wait for the window; the window never waits for them. Filming without the window's scene, and
 * encoding, are the jobs of {@code tellosimulator.video}.
 */
package tellosimulator.view.video;
