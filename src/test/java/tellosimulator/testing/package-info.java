/**
 * What tests of whole drones stand on.
 *
 * <p>{@link tellosimulator.testing.SimulatedDrone} is a simulation without sockets and threads that
 * a test steps itself. For the thread of the test. It may import everything but the window.
 */
package tellosimulator.testing;
