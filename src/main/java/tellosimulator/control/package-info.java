/**
 * The control channel, which offers the functions of the Java test kit to tests in other languages.
 * {@link tellosimulator.control.ControlServer} accepts JSON lines over TCP on loopback, one request
 * per line, and sends one answer for each. {@code Requests} is the table of requests. Each
 * connection has its own thread.
 *
 * <p>All requests are executed by {@code junit.TelloSimulator}, without a test framework. The
 * control channel never sends or receives the datagrams of a drone.
 */
package tellosimulator.control;
