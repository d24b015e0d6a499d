/**
 * UDP: commands in, replies and state lines out.
 *
 * <p>{@link tellosimulator.network.DroneNetwork} opens the sockets; a {@link
 * tellosimulator.network.CommandConnection} receives on a thread for each socket; {@link
 * tellosimulator.network.CommandResponseSender} and {@link tellosimulator.network.StateConnection}
 * send on the simulation thread. {@link tellosimulator.network.DatagramPort} hides the socket, so
 * that tests need none. The package imports {@code sim} and what that stands on. What a command
 * means is not its job.
 */
package tellosimulator.network;
