package tellosimulator.sim;

import java.util.Locale;
import java.util.Optional;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.command.WireText;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.Fault;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * An event of the simulation, with its simulated time and a description in words. An event that is
 * not a {@link ForDrone} concerns all drones. Immutable.
 */
public interface SimEvent {

  /**
   * Returns the time of the event: the end of the step in which it happened, or of the last step if
   * it happened between steps.
   */
  SimTime time();

  /** Returns the one-line description. */
  Phrase phrase();

  /** Returns the description in English. */
  default String words() {
    return phrase().english();
  }

  /** Returns the importance of the event to a user who reads a log. It is the same in all logs. */
  default Severity severity() {
    return Severity.INFORMATION;
  }

  /** An event of one drone. */
  interface ForDrone extends SimEvent {

    /** Returns the number of the drone, from 1. */
    int drone();

    /** Whether the description lacks the drone as its subject, as {@code took off} does. */
    default boolean lacksSubject() {
      return false;
    }
  }

  /** An event that needs attention. */
  interface Warning extends SimEvent {
    @Override
    default Severity severity() {
      return Severity.WARNING;
    }
  }

  /** An event about a text that a host sent. */
  sealed interface FromPeer extends ForDrone {
    Peer peer();

    /** Returns the text without header, one character per byte (ISO-8859-1). */
    String text();
  }

  /** An event about a text that a drone handled as a command. */
  sealed interface OfCommand extends FromPeer {

    /** Returns the command. */
    Request request();

    @Override
    default Peer peer() {
      return request().peer();
    }

    @Override
    default String text() {
      return request().text();
    }
  }

  /** A command arrived. Its outcome follows in another event. */
  record CommandReceived(SimTime time, int drone, Request request) implements OfCommand {
    @Override
    public Severity severity() {
      return ofText(text());
    }

    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s", WireText.printable(text()), peer());
    }
  }

  /** A text arrived that the drone ignores. */
  record CommandIgnored(SimTime time, int drone, Peer peer, String text, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s ignored: %s", WireText.printable(text), peer, reason);
    }
  }

  /** The drone refused a command, and its reply reports the refusal. */
  record CommandRefused(SimTime time, int drone, Request request, Reply reply, Phrase reason)
      implements OfCommand, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` refused: %s; answered `%s`",
          WireText.printable(text()), reason, WireText.printable(reply.text()));
    }
  }

  /** The drone began a command but could not complete it. Its reply reports the failure. */
  record CommandFailed(SimTime time, int drone, Request request, Reply reply, Phrase reason)
      implements OfCommand, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` failed: %s; answered `%s`",
          WireText.printable(text()), reason, WireText.printable(reply.text()));
    }
  }

  /** The drone replied to a command. */
  record ReplySent(SimTime time, int drone, Request request, Reply reply) implements OfCommand {
    @Override
    public Severity severity() {
      return ofText(text());
    }

    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` answered `%s`",
          WireText.printable(text()), WireText.printable(reply.text().stripTrailing()));
    }
  }

  /** A command was lost on its way to the drone. */
  record CommandLost(SimTime time, int drone, Peer peer, String text, Phrase cause)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s was lost by %s", WireText.printable(text), peer, cause);
    }
  }

  /**
   * A reply was lost on its way to the operator.
   *
   * @param text the text of the reply
   */
  record ReplyLost(SimTime time, int drone, Peer peer, String text, Phrase cause)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of(
          "the answer `%s` to %s was lost by %s",
          WireText.printable(text.stripTrailing()), peer, cause);
    }
  }

  /** A fault begins to affect a drone. */
  record FaultBegan(SimTime time, int drone, Fault fault) implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("the fault %s begins", fault.text());
    }
  }

  /** A fault no longer affects a drone. */
  record FaultEnded(SimTime time, int drone, Fault fault) implements ForDrone {
    @Override
    public Phrase phrase() {
      return Phrase.of("the fault %s is over", fault.text());
    }
  }

  /**
   * Datagrams were dropped because the commands, replies or state lines in transit exceeded the
   * capacity.
   *
   * @param count the number of dropped datagrams; the oldest are dropped first
   */
  record WaitingDropped(SimTime time, int drone, long count) implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("%,d datagrams were dropped: too many wait for their time", count);
    }
  }

  /** A text from a host that does not operate the drone was rejected without effect. */
  record TurnedAway(SimTime time, int drone, Peer peer, String text, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s turned away: %s", WireText.printable(text), peer, reason);
    }
  }

  /**
   * Datagrams from a host were rejected before they reached the drone.
   *
   * @param host the sender's address
   */
  record DatagramsDropped(SimTime time, int drone, String host, long count, Phrase reason)
      implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("%,d datagrams from %s turned away: %s", count, host, reason);
    }
  }

  /**
   * Events about ineffective datagrams from a host were omitted from a log.
   *
   * @param host the sender's address; empty if the events concern many senders
   */
  record Omitted(SimTime time, int drone, Optional<String> host, long count)
      implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return host.map(sender -> Phrase.of("%,d more from %s are not shown", count, sender))
          .orElse(Phrase.of("%,d more from many hosts are not shown", count));
    }
  }

  /**
   * The drone has a new operator, and now sends state and video to that operator's host.
   *
   * @param before the previous operator, if any
   */
  record OperatorChanged(SimTime time, int drone, Peer peer, int statePort, Optional<Peer> before)
      implements ForDrone {
    @Override
    public boolean lacksSubject() {
      return true;
    }

    @Override
    public Severity severity() {
      return before.isPresent() ? Severity.WARNING : Severity.INFORMATION;
    }

    @Override
    public Phrase phrase() {
      Phrase now =
          Phrase.of(
              "is operated by %s now, its state goes to port %d of that host",
              peer.host(), statePort);
      return before.map(lost -> Phrase.of("%s; %s has lost it", now, lost.host())).orElse(now);
    }
  }

  /** A drone's flight event: neither a command nor a reply. */
  record DroneFlight(SimTime time, int drone, FlightEvent event) implements ForDrone {
    @Override
    public boolean lacksSubject() {
      return true;
    }

    @Override
    public Severity severity() {
      if (event instanceof FlightEvent.Crashed) {
        return Severity.ERROR;
      }
      boolean unasked =
          event instanceof FlightEvent.Fell || event instanceof FlightEvent.LandsByItself;
      return unasked ? Severity.WARNING : Severity.INFORMATION;
    }

    @Override
    public Phrase phrase() {
      return event.phrase();
    }
  }

  /** The world or its clock changed. */
  record WorldChanged(SimTime time, Phrase phrase) implements SimEvent {}

  /** A new run started: time is 0, and no drone has received any command. */
  record RunStarted(SimTime time) implements SimEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("the simulation starts again");
    }
  }

  /**
   * Simulated time was skipped because the machine was too slow. The program that flies the drone
   * is not the cause.
   *
   * @param seconds the time skipped since the previous such event [simulated s]
   * @param clock the clock, which includes all time lost since the start
   */
  record TimeLost(SimTime time, double seconds, SimSnapshot.Clock clock) implements SimEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("%.1f s of simulated time left out: this machine is busy", seconds);
    }
  }

  /** Returns the event as a line of a log: simulated time, drone, description. */
  default String line() {
    String who = this instanceof ForDrone one ? "drone " + one.drone() : "all";
    return String.format(Locale.ROOT, "%9.3f s  %s: %s", time().seconds(), who, words());
  }

  private static Severity ofText(String text) {
    boolean frequent = WireText.isRead(text) || WireText.isSteering(text);
    return frequent ? Severity.DETAIL : Severity.INFORMATION;
  }
}
