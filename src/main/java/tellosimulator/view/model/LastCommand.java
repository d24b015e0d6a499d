package tellosimulator.view.model;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.command.WireText;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/**
 * The command of which something was heard last, and what became of it. Reads and {@code rc} do not
 * count. Told on the simulation thread; for any thread.
 */
public final class LastCommand implements SimListener {

  /** What became of a command. */
  public enum Outcome {
    /** It is not answered yet. */
    RUNNING,
    DONE,
    /** It was refused, failed, was ignored or lost. */
    FAILED
  }

  /**
   * A command.
   *
   * @param drone its number, from 1
   * @param text as it was sent
   * @param reply as it was answered; empty without an answer
   */
  public record Shown(int drone, String text, Outcome outcome, String reply) {}

  private final AtomicReference<Optional<Shown>> newest = new AtomicReference<>(Optional.empty());

  /** The command; empty if there was none yet. */
  public Optional<Shown> newest() {
    return newest.get();
  }

  /** Forgets it. */
  public void clear() {
    newest.set(Optional.empty());
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.FromPeer about && about.severity() != Severity.DETAIL) {
      outcome(about).ifPresent(shown -> newest.set(Optional.of(shown)));
    }
  }

  private static Optional<Shown> outcome(SimEvent.FromPeer about) {
    if (about instanceof SimEvent.CommandReceived) {
      return shown(about, Outcome.RUNNING, "");
    }
    if (about instanceof SimEvent.ReplySent sent) {
      return shown(about, Outcome.DONE, sent.reply().text());
    }
    if (about instanceof SimEvent.CommandRefused refused) {
      return shown(about, Outcome.FAILED, refused.reply().text());
    }
    if (about instanceof SimEvent.CommandFailed failed) {
      return shown(about, Outcome.FAILED, failed.reply().text());
    }
    boolean unanswered =
        about instanceof SimEvent.CommandIgnored || about instanceof SimEvent.CommandLost;
    return unanswered ? shown(about, Outcome.FAILED, "") : Optional.empty();
  }

  private static Optional<Shown> shown(SimEvent.FromPeer about, Outcome outcome, String reply) {
    return Optional.of(
        new Shown(
            about.drone(),
            WireText.printable(about.text()),
            outcome,
            WireText.printable(reply.stripTrailing())));
  }
}
