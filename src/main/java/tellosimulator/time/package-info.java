/**
 * Simulated time and its relation to the wall clock.
 *
 * <p>{@link tellosimulator.time.SimTime} is the clock of everything a drone does. {@link
 * tellosimulator.time.Pacer} is the only reader of the wall clock and the only sleeper outside the
 * window; {@link tellosimulator.time.Threads} is the only place that starts threads. The package
 * imports nothing of the project. What happens in a step is not its job.
 */
package tellosimulator.time;
