package tellosimulator.sim;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.command.WireText;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Stores the command that was most recently received or that most recently failed, with its
 * outcome. Read commands and {@code rc} are ignored, and so is the late success of an earlier
 * command. Events arrive on the simulation thread. Thread-safe.
 */
public final class LastCommand implements SimListener {

  /** The outcome of a command. */
  public enum Outcome {
    /** Not answered yet. */
    RUNNING,
    DONE,
    /** Refused, failed, ignored or lost. */
    FAILED
  }

  /**
   * A command and its outcome.
   *
   * @param drone the number of the drone, from 1
   * @param number the number of the command among all commands of the drone; 0 if the drone never
   *     accepted it
   * @param text the command in printable form
   * @param reply the reply of the drone in printable form; empty if there is none
   * @param reason the reason for a failure, if it is known
   */
  public record Shown(
      int drone, int number, String text, Outcome outcome, String reply, Optional<Phrase> reason) {

    private boolean isAbout(Shown other) {
      return drone == other.drone && number == other.number;
    }
  }

  private final AtomicReference<Optional<Shown>> newest = new AtomicReference<>(Optional.empty());

  private volatile SimTime heard = SimTime.ZERO;

  /**
   * Returns the latest command; empty if there has been none yet, or none since the last {@link
   * #clear}.
   */
  public Optional<Shown> newest() {
    return newest.get();
  }

  /**
   * Returns the simulated time since the last datagram from any program, or since the start of the
   * run [s]. Read commands and {@code rc} count, too.
   *
   * @param nowSeconds the current simulated time [s]
   */
  public double silence(double nowSeconds) {
    return Math.max(0, nowSeconds - heard.seconds());
  }

  /** Forgets the latest command. */
  public void clear() {
    newest.set(Optional.empty());
  }

  @Override
  public void onInput(SimTime now, SimInput input) {
    if (input instanceof SimInput.Datagram) {
      heard = now;
    }
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.FromPeer || event instanceof SimEvent.RunStarted) {
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
            about instanceof SimEvent.OfCommand known ? known.request().number() : 0,
            WireText.printable(about.text()),
            outcome,
            WireText.printable(reply.stripTrailing()),
            reason));
  }
}
