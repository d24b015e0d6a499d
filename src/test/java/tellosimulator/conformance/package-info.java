/**
 * Tests of real client libraries that fly the runnable jar.
 *
 * <p>{@code ClientFlight} runs {@code conformance/run.py}, which starts the simulator and a client
 * and checks replies and positions; the tests define which client flies over which network. {@code
 * PytestIT} runs the tests of {@code examples/testing/pytest}. They run in Maven's {@code verify},
 * after the jar has been built. The expected replies are defined in the scripts in {@code
 * conformance}, not here.
 */
package tellosimulator.conformance;
