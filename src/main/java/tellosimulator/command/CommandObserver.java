package tellosimulator.command;

import tellosimulator.controller.FlightObserver;
import tellosimulator.words.Phrase;

/**
 * A listener that is notified of a drone's flight events, and of its traffic with operators. Called
 * on the simulation thread.
 */
public interface CommandObserver extends FlightObserver {

  /** Called when a host becomes the operator, before that host receives its reply. */
  void operatorChanged(OperatorSession.Takeover takeover, OperatorEndpoint link);

  /** Called when a text arrives that is handled as a command. The reply is reported separately. */
  void received(Request request);

  /** Called when a text arrives to which the drone does not react. */
  void ignored(Peer peer, String text, Phrase reason);

  /**
   * Called when a text arrives from a host that does not operate the drone. The text has no effect.
   *
   * @param reason the reason, worded to follow "turned away: "
   */
  void turnedAway(Peer peer, String text, Phrase reason);

  /** Called for each reply that reports neither a refusal nor a failure. {@code stop} has two. */
  void replied(Request request, Reply reply);

  /**
   * Called when the drone could not complete a command that it had begun.
   *
   * @param reason the reason, worded to follow "failed: "
   */
  void failed(Request request, Reply reply, Phrase reason);

  /**
   * Called when the drone refused a command.
   *
   * @param reason the reason, worded to follow "refused: "
   */
  void refused(Request request, Reply reply, Phrase reason);
}
