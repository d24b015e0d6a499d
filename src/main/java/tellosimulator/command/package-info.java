/**
 * The text interface: from bytes of the wire to commands, and from answers back to texts.
 *
 * <p>{@link tellosimulator.command.CommandSyntax} is the table of all commands; {@link
 * tellosimulator.command.CommandHandler} checks a text against it and hands a {@link
 * tellosimulator.command.Command} to a {@link tellosimulator.command.CommandTarget}, which answers
 * through a {@link tellosimulator.command.Responder}. All of it runs on the simulation thread. The
 * package imports {@code profile}, {@code time} and {@code math}. Sockets are not its job, and
 * neither is flying.
 */
package tellosimulator.command;
