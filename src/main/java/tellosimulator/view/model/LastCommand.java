package tellosimulator.view.model;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.command.WireText;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The command that was sent or failed last, and what became of it. Reads and {@code rc} do not
 * count, nor does the success of a command that was sent before it: what is shown is the last line
 * of the log. Told on the simulation thread; for any thread.
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
   * @param reason why it failed, if it is known
   */
  public record Shown(
      int drone, String text, Outcome outcome, String reply, Optional<Phrase> reason) {

    private boolean isAbout(Shown other) {
      return drone == other.drone && text.equals(other.text);
    }
  }

  private final AtomicReference<Optional<Shown>> newest = new AtomicReference<>(Optional.empty());

  private volatile SimTime heard = SimTime.ZERO;

  /** The command; empty if there was none yet. */
  public Optional<Shown> newest() {
    return newest.get();
  }

  /** Simulated time since something was heard of any program, reads and {@code rc} too [s]. */
  public double silence(double nowSeconds) {
    return Math.max(0, nowSeconds - heard.seconds());
  }

  /** Forgets it. */
  public void clear() {
    newest.set(Optional.empty());
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.FromPeer || event instanceof SimEvent.Restarted) {
      heard = event.time();
    }
    if (event instanceof SimEvent.FromPeer about && about.severity() != Severity.DETAIL) {
      outcome(about).ifPresent(this::show);
    }
  }

  private void show(Shown next) {
    newest.updateAndGet(
        last ->
            next.outcome != Outcome.DONE || last.filter(next::isAbout).isPresent()
                ? Optional.of(next)
                : last);
  }

  private static Optional<Shown> outcome(SimEvent.FromPeer about) {
    if (about instanceof SimEvent.CommandReceived) {
      return shown(about, Outcome.RUNNING, "", Optional.empty());
    }
    if (about instanceof SimEvent.ReplySent sent) {
      return shown(about, Outcome.DONE, sent.reply().text(), Optional.empty());
    }
    if (about instanceof SimEvent.CommandRefused refused) {
      return failed(about, refused.reply().text(), refused.reason());
    }
    if (about instanceof SimEvent.CommandFailed failed) {
      return failed(about, failed.reply().text(), failed.reason());
    }
    if (about instanceof SimEvent.CommandIgnored ignored) {
      return failed(about, "", ignored.reason());
    }
    if (about instanceof SimEvent.CommandLost lost) {
      return failed(about, "", lost.cause());
    }
    return Optional.empty();
  }

  private static Optional<Shown> failed(SimEvent.FromPeer about, String reply, Phrase reason) {
    return shown(about, Outcome.FAILED, reply, Optional.of(reason));
  }

  private static Optional<Shown> shown(
      SimEvent.FromPeer about, Outcome outcome, String reply, Optional<Phrase> reason) {
    return Optional.of(
        new Shown(
            about.drone(),
            WireText.printable(about.text()),
            outcome,
            WireText.printable(reply.stripTrailing()),
            reason));
  }
}
