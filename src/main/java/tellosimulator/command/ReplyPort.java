package tellosimulator.command;

/** The way out for replies. Called on the simulation thread; must neither block nor throw. */
@FunctionalInterface
public interface ReplyPort {

  /**
   * Sends a text to a peer.
   *
   * @param text one character a byte (ISO-8859-1)
   */
  void reply(Peer peer, String text);
}
