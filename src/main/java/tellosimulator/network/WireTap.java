package tellosimulator.network;

import java.net.InetSocketAddress;

/**
 * A listener that is notified of each datagram that drones send. It is called in the path of the
 * datagram, on the thread that sends it. Implementations must be quick, and must neither block nor
 * throw. Received datagrams are reported to {@link tellosimulator.sim.SimListener#onInput} instead.
 */
@FunctionalInterface
public interface WireTap {

  /** The kind of content of a datagram. */
  enum Kind {
    COMMAND("command"),
    REPLY("reply"),
    STATE("state"),
    VIDEO("video");

    private final String word;

    Kind(String word) {
      this.word = word;
    }

    /** Returns the word for this kind in files. */
    public String word() {
      return word;
    }
  }

  /** A tap that does nothing. */
  WireTap NONE = (drone, kind, from, to, bytes) -> {};

  /**
   * Called when a datagram is about to be sent.
   *
   * @param drone the drone's number, from 1
   * @param from the drone's own address
   * @param bytes the content; must not be modified, and does not change afterwards
   */
  void sent(int drone, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes);
}
