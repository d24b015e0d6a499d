/**
 * What tests of whole drones stand on.
 *
 * <p>{@link tellosimulator.testing.SteppedDrone} is a simulation without sockets and threads that a
 * test steps itself; {@link tellosimulator.testing.CapturedLog} is what is logged meanwhile, and
 * {@link tellosimulator.testing.UnexpectedErrors} fails tests that log an error which they do not
 * look for. For the thread of the test. It may import everything but the window.
 */
package tellosimulator.testing;
