/**
 * The control channel: what the test kit offers to Java, for tests in other languages. {@link
 * tellosimulator.control.ControlServer} takes JSON lines over TCP on loopback, one request a line,
 * and gives one answer for each; {@code Requests} is the table of what can be asked. Each
 * connection has a thread of its own.
 *
 * <p>All of it is done by {@code junit.TelloSimulator}, without any framework. Nothing of it is
 * ever on a drone's wire, and no drone's command is taken here.
 */
package tellosimulator.control;
