/**
 * The player: a window that shows a recorded flight. The package itself neither simulates flights
 * nor opens sockets.
 *
 * <p>{@link tellosimulator.view.replay.ReplayFlight} is a recording that has been read; {@link
 * tellosimulator.view.replay.ReplayWindow} shows the recording, optionally together with another
 * one as a ghost. All parts are bound to {@code FxReplay}, whose {@code Playback} determines the
 * displayed moment. All types are confined to the JavaFX thread, except for reading recordings. The
 * appearance of the room is {@code view.world}'s job.
 */
package tellosimulator.view.replay;
