/**
 * Flies recorded flights again, and compares what becomes of them.
 *
 * <p>{@link tellosimulator.replay.Replay} builds the simulation that a recording tells of, without
 * sockets, and hands it each input after the step after which it was taken; what it does is
 * recorded in turn. {@link tellosimulator.replay.Repetition} says where both recordings differ,
 * byte by byte. All of it works on the calling thread, as fast as that can. The package imports
 * {@code recording} and what that stands on. Showing flights is not its job.
 */
package tellosimulator.replay;
