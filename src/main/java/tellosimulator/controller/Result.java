package tellosimulator.controller;

import tellosimulator.words.Phrase;

/** The immediate result of an order to a drone. */
public sealed interface Result {

  /** The order is complete. */
  Result DONE = new Done();

  /** The order is complete. */
  record Done() implements Result {}

  /**
   * The drone refuses the order.
   *
   * @param reason the reason, worded to follow "refused: "
   */
  record Refused(RefusalKind kind, Phrase reason) implements Result {}

  /** The order has begun. Its completion reports the end. */
  record Running(Completion completion) implements Result {}
}
