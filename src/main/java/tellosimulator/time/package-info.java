/**
 * Simulated time and its relation to the wall clock.
 *
 * <p>{@link tellosimulator.time.SimTime} is the clock of all drones. {@link
 * tellosimulator.time.Pacer} and {@link tellosimulator.time.Ticker} wait for the wall clock on all
 * threads except the window's. The package imports no other package of the project. Other packages
 * start the threads and define what happens in a step.
 */
package tellosimulator.time;
