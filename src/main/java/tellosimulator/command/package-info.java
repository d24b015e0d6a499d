/**
 * The protocol between programs and drones: {@link tellosimulator.command.DroneProtocol}, and its
 * implementation for the SDK's texts, {@link tellosimulator.command.TextProtocol}.
 *
 * <p>{@link tellosimulator.command.CommandSyntax} is the table of all commands. {@link
 * tellosimulator.command.CommandHandler} checks a text against the table, and passes a {@link
 * tellosimulator.command.Command} to {@link tellosimulator.command.DroneCommands}. That class gives
 * the order to the {@code controller}, and turns the result into replies. {@link
 * tellosimulator.command.StateLines} reports the drone's state. All mutable state of this package
 * is confined to the simulation thread. Sockets and flight logic belong to other packages.
 */
package tellosimulator.command;
