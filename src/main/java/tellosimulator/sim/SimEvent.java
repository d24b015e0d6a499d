package tellosimulator.sim;

import java.util.Locale;
import java.util.Optional;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.WireText;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.Fault;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Something that happened in the simulation, with its simulated time and in plain words. What is no
 * {@link ForDrone} concerns all drones. Immutable; for any thread.
 */
public interface SimEvent {

  /** The end of the last step before it happened, or of the step in which it happened. */
  SimTime time();

  /** For people, one line. */
  Phrase phrase();

  /** The same in English. */
  default String words() {
    return phrase().english();
  }

  /** How much it matters to people; the same in every log. */
  default Severity severity() {
    return Severity.INFORMATION;
  }

  /** Something that concerns one drone. */
  interface ForDrone extends SimEvent {

    /** Its number, from 1. */
    int drone();

    /** Whether the line is a clause about the drone, which lacks its subject: {@code took off}. */
    default boolean lacksSubject() {
      return false;
    }
  }

  /** Something that people should look at. */
  interface Warning extends SimEvent {
    @Override
    default Severity severity() {
      return Severity.WARNING;
    }
  }

  /** Something about a text that a host sent. */
  sealed interface FromPeer extends ForDrone {
    Peer peer();

    /** The text without header, one character a byte (ISO-8859-1). */
    String text();
  }

  /** A command arrived; what becomes of it follows. */
  record CommandReceived(SimTime time, int drone, Peer peer, String text) implements FromPeer {
    @Override
    public Severity severity() {
      return ofText(text);
    }

    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s", WireText.printable(text), peer);
    }
  }

  /** Something arrived that the drone does not react to. */
  record CommandIgnored(SimTime time, int drone, Peer peer, String text, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s ignored: %s", WireText.printable(text), peer, reason);
    }
  }

  /** A command was refused, and the drone said so. */
  record CommandRefused(SimTime time, int drone, Peer peer, String text, Reply reply, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` refused: %s; answered `%s`",
          WireText.printable(text), reason, WireText.printable(reply.text()));
    }
  }

  /** A command was begun, but came to another end, and the drone said so. */
  record CommandFailed(SimTime time, int drone, Peer peer, String text, Reply reply, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` failed: %s; answered `%s`",
          WireText.printable(text), reason, WireText.printable(reply.text()));
    }
  }

  /** A command was answered. */
  record ReplySent(SimTime time, int drone, Peer peer, String text, Reply reply)
      implements FromPeer {
    @Override
    public Severity severity() {
      return ofText(text);
    }

    @Override
    public Phrase phrase() {
      return Phrase.of(
          "`%s` answered `%s`",
          WireText.printable(text), WireText.printable(reply.text().stripTrailing()));
    }
  }

  /** A command never arrived at the drone. */
  record CommandLost(SimTime time, int drone, Peer peer, String text, Phrase cause)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s was lost by %s", WireText.printable(text), peer, cause);
    }
  }

  /**
   * A reply never arrived where it was to go.
   *
   * @param text of the reply
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

  /** A fault acts on a drone from now on. */
  record FaultBegan(SimTime time, int drone, Fault fault) implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("the fault %s begins", fault.text());
    }
  }

  /** A fault acts on a drone no more. */
  record FaultEnded(SimTime time, int drone, Fault fault) implements ForDrone {
    @Override
    public Phrase phrase() {
      return Phrase.of("the fault %s is over", fault.text());
    }
  }

  /**
   * Commands, replies or state lines found no room among those that wait for their time.
   *
   * @param count how many, the oldest ones
   */
  record WaitingDropped(SimTime time, int drone, long count) implements ForDrone, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("%,d datagrams were dropped: too many wait for their time", count);
    }
  }

  /** Something came from a host that does not operate the drone, and had no effect. */
  record TurnedAway(SimTime time, int drone, Peer peer, String text, Phrase reason)
      implements FromPeer, Warning {
    @Override
    public Phrase phrase() {
      return Phrase.of("`%s` from %s turned away: %s", WireText.printable(text), peer, reason);
    }
  }

  /**
   * Datagrams of a host were turned away before the drone saw them.
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
   * Events about what a host sent in vain were left out of a log.
   *
   * @param host the sender's address; empty if there are too many senders to name them
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
   * State and video go to another host from now on.
   *
   * @param before who operated the drone until then, if anybody
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

  /** Something happened to a drone, other than a command or a reply. */
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

  /** The world or its clock was changed. */
  record WorldChanged(SimTime time, Phrase phrase) implements SimEvent {}

  /** Everything began anew: time is 0, and no drone has been commanded yet. */
  record Restarted(SimTime time) implements SimEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("the simulation begins anew");
    }
  }

  /**
   * Simulated time was left out, because the machine was too slow; no fault of the flight.
   *
   * @param seconds how much, since it was told the last time [simulated s]
   * @param clock with all that was lost since the start
   */
  record TimeLost(SimTime time, double seconds, SimSnapshot.Clock clock) implements SimEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("%.1f s of simulated time left out: this machine is busy", seconds);
    }
  }

  /** The event as a line of a log: simulated time, drone, words. */
  default String line() {
    String who = this instanceof ForDrone one ? "drone " + one.drone() : "all";
    return String.format(Locale.ROOT, "%9.3f s  %s: %s", time().seconds(), who, words());
  }

  private static Severity ofText(String text) {
    boolean frequent = text.endsWith("?") || text.startsWith(CommandSyntax.RC.verb() + " ");
    return frequent ? Severity.DETAIL : Severity.INFORMATION;
  }
}
