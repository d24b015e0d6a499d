package tellosimulator.command;

/**
 * The way out for replies of one drone. Called on the simulation thread; must neither block nor
 * throw.
 */
@FunctionalInterface
public interface ReplyPort {

  /**
   * Sends a text to a peer.
   *
   * @param text one character a byte (ISO-8859-1)
   */
  void reply(Peer peer, String text);

  /** The drone's operator, or where it takes what the drone sends, is another one from now on. */
  default void linked(Link link) {}
}
