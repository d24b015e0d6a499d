package tellosimulator.controller;

import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.words.Phrase;

/**
 * Reports the end of an order that takes time. At most one listener waits for the end. An order
 * that is superseded never completes. Confined to the simulation thread.
 */
public final class Completion {

  /** A listener that is notified when the order ends. */
  public interface Listener {

    /** Called when the order ends as planned. */
    void done();

    /**
     * Called when the order ends in any other way.
     *
     * @param reason the reason, worded to follow "failed: "
     */
    void failed(RefusalKind kind, Phrase reason);
  }

  /** The completion of motions that no order requested, such as hovering or a safety landing. */
  static final Completion NONE = new Completion();

  private Supplier<String> name = () -> "";
  private Optional<Listener> listener = Optional.empty();

  Completion() {}

  /**
   * Registers the listener that waits for the end.
   *
   * @param order the order as its sender wrote it
   */
  public void await(String order, Listener newListener) {
    name = () -> order;
    listener = Optional.of(newListener);
  }

  /** Returns the order as its sender wrote it; empty if no listener is waiting. */
  String name() {
    return name.get();
  }

  void done() {
    listener.ifPresent(Listener::done);
  }

  void failed(RefusalKind kind, Phrase reason) {
    listener.ifPresent(waiting -> waiting.failed(kind, reason));
  }

  /**
   * Returns the completion of a sequence: this order, then the order that {@code next} begins. If
   * this order fails, the sequence fails as well.
   */
  Completion then(Supplier<Result> next) {
    Completion whole = new Completion();
    leadTo(whole, next);
    return whole;
  }

  private void leadTo(Completion whole, Supplier<Result> next) {
    name = whole::name;
    listener =
        Optional.of(
            new Listener() {
              @Override
              public void done() {
                whole.follow(next.get());
              }

              @Override
              public void failed(RefusalKind kind, Phrase reason) {
                whole.failed(kind, reason);
              }
            });
  }

  private void follow(Result part) {
    if (part instanceof Result.Refused refused) {
      failed(refused.kind(), refused.reason());
    } else if (part instanceof Result.Running running) {
      running.completion().leadTo(this, () -> Result.DONE);
    } else {
      done();
    }
  }
}
