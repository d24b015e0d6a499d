/**
 * The player: a window on a recorded flight, in which nothing is flown and no socket is opened.
 *
 * <p>{@link tellosimulator.view.replay.ReplayFlight} is a recording that was read; {@link
 * tellosimulator.view.replay.ReplayWindow} shows it in a stage, with another one as a ghost if
 * somebody wants to compare. {@code FxReplay} is what all parts are bound to, and its {@code
 * Playback} the moment that they show. Everything is for the JavaFX thread, but for reading. What
 * the room looks like is {@code view.world}'s job.
 */
package tellosimulator.view.replay;
