package tellosimulator.network;

import java.net.InetSocketAddress;
import tellosimulator.command.Peer;

/**
 * Sees each datagram that drones take and send. It is called on the way of the datagram, on
 * whatever thread handles that: it must be quick, and must neither wait nor throw.
 */
public interface WireTap {

  /** What a datagram is. */
  enum Kind {
    COMMAND("command"),
    REPLY("reply"),
    STATE("state"),
    VIDEO("video");

    private final String word;

    Kind(String word) {
      this.word = word;
    }

    /** As files have it. */
    public String word() {
      return word;
    }
  }

  /** Looks at nothing. */
  WireTap NONE =
      new WireTap() {
        @Override
        public void received(int drone, Peer peer, String text) {}

        @Override
        public void sent(
            int drone, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {}
      };

  /**
   * A datagram came to a drone, and is taken next. What was turned away before is not told.
   *
   * @param drone its number, from 1
   * @param text one character a byte (ISO-8859-1)
   */
  void received(int drone, Peer peer, String text);

  /**
   * A datagram leaves next.
   *
   * @param drone its number, from 1
   * @param from the drone's own address
   * @param bytes must not be changed; nobody changes them afterwards
   */
  void sent(int drone, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes);
}
