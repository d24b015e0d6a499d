/**
 * Receives commands and sends replies and state lines over UDP.
 *
 * <p>{@link tellosimulator.network.DroneNetwork} opens the sockets. A {@link
 * tellosimulator.network.Receiver} reads all of them on one thread, and passes each datagram to the
 * {@link tellosimulator.network.CommandConnection} of its socket. {@link
 * tellosimulator.network.DatagramSender} sends on the simulation thread. {@link
 * tellosimulator.network.DatagramPort} hides the socket, so that tests need no socket. The package
 * imports {@code sim} and the packages below it. Other packages define what a command means.
 */
package tellosimulator.network;
