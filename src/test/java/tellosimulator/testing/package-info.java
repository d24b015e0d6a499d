/**
 * The basis of tests with whole drones.
 *
 * <p>{@link tellosimulator.testing.SteppedDrone} is a simulation without sockets and threads that a
 * test steps itself; {@link tellosimulator.testing.CapturedLog} captures log events, and {@link
 * tellosimulator.testing.UnexpectedErrors} fails tests that log an error which they do not expect.
 * Confined to the test's thread. It may import everything except the window.
 */
package tellosimulator.testing;
