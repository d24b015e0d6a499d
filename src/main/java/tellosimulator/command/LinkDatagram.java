package tellosimulator.command;

import tellosimulator.fault.LinkDirection;

/**
 * A datagram between a drone and a peer. Its bytes must not be modified.
 *
 * @param direction what the datagram carries: a command, a reply or a state line
 * @param peer the other end, and the drone's own address
 * @param expected whether a client is waiting for it, so that simulated time must pass until it
 *     arrives
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record LinkDatagram(LinkDirection direction, Peer peer, byte[] bytes, boolean expected) {

  /** Returns a datagram to the drone. */
  public static LinkDatagram command(Peer peer, byte[] bytes) {
    return new LinkDatagram(LinkDirection.COMMANDS, peer, bytes, true);
  }

  /** Returns a reply to a peer. */
  public static LinkDatagram reply(Peer peer, byte[] bytes) {
    return new LinkDatagram(LinkDirection.REPLIES, peer, bytes, true);
  }

  /** Returns a copy with other bytes. */
  public LinkDatagram with(byte[] newBytes) {
    return new LinkDatagram(direction, peer, newBytes, expected);
  }

  /** Returns the bytes as a text, one character per byte (ISO-8859-1). */
  public String text() {
    return WireText.decode(bytes);
  }
}
