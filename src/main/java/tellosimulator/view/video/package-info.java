/**
 * The drones' video in the window: showing and saving it.
 *
 * <p>{@link tellosimulator.view.video.WindowVideo} holds the streams of all drones; {@link
 * tellosimulator.view.video.VideoView} shows one. Pictures come from video threads. The window and
 * the video threads do not wait for each other. Rendering and encoding are the jobs of {@code
 * tellosimulator.video}.
 */
package tellosimulator.view.video;
