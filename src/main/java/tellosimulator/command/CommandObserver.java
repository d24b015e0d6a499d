package tellosimulator.command;

import tellosimulator.words.Phrase;

/** Is told what happens between operators and drone. Called on the simulation thread. */
public interface CommandObserver {

  /** A text arrived that is taken for a command; its answer follows separately. */
  void received(Peer peer, String text);

  /** Something arrived that the drone does not react to. */
  void ignored(Peer peer, String text, Phrase reason);

  /**
   * Something arrived from a host that does not operate the drone, and has no effect.
   *
   * @param reason why, in plain words that follow "turned away: "
   */
  void turnedAway(Peer peer, String text, Phrase reason);

  /** A reply to {@code text} was given. */
  void replied(Peer peer, String text, Reply reply);

  /**
   * {@code text} was begun, but came to another end.
   *
   * @param reason why, in plain words that follow "failed: "
   */
  void failed(Peer peer, String text, Reply reply, Phrase reason);

  /**
   * {@code text} was refused.
   *
   * @param reason why, in plain words that follow "refused: "
   */
  void refused(Peer peer, String text, Reply reply, Phrase reason);
}
