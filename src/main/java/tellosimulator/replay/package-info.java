/**
 * Replays recorded flights, and compares the results with the recordings.
 *
 * <p>{@link tellosimulator.replay.Replay} creates the simulation of a recording, without sockets,
 * and submits each input after the same step as in the recording; the replay is recorded as well.
 * {@link tellosimulator.replay.Repetition} lists where the two recordings first differ, compared
 * byte by byte. Everything runs on the calling thread, as fast as possible. The package imports
 * {@code recording} and the packages below it. It does not show flights.
 */
package tellosimulator.replay;
