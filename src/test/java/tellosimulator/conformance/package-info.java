/**
 * Real client packages that fly the runnable jar.
 *
 * <p>{@code ClientFlight} runs {@code conformance/run.py}, which starts the simulator and a client
 * and judges replies and positions; the tests say which client flies over which network. {@code
 * PytestIT} runs the tests of {@code examples/testing/pytest}. They run in Maven's {@code verify},
 * after the jar has been made. What the replies must be is not their job but that of the scripts in
 * {@code conformance}.
 */
package tellosimulator.conformance;
