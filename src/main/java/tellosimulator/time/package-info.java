/**
 * Simulated time and its relation to the wall clock.
 *
 * <p>{@link tellosimulator.time.SimTime} is the clock of everything a drone does. {@link
 * tellosimulator.time.Pacer} and {@link tellosimulator.time.Ticker} read the wall clock and sleep
 * for everybody outside the window. The package imports nothing of the project. Threads and what
 * happens in a step are not its job.
 */
package tellosimulator.time;
