package tellosimulator.command;

/**
 * A text that a drone handles as a command. Immutable.
 *
 * @param number the sequence number of the command at this drone, from 1
 * @param peer the sender
 * @param text the text without header, one character per byte (ISO-8859-1)
 */
public record Request(int number, Peer peer, String text) {}
