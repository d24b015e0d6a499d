package tellosimulator.view.log;

import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;

/**
 * A line of the log. Immutable; its words are made anew for each language.
 *
 * @param time in the simulation
 * @param about which drone
 * @param saying what happened
 * @param exchange the command that it is about, if it is one that the drone took
 */
record LogLine(
    SimTime time, LogLevel level, About about, Saying saying, Optional<Exchange> exchange) {

  /** A line that is about no command. */
  LogLine(SimTime time, LogLevel level, About about, Saying saying) {
    this(time, level, about, saying, Optional.empty());
  }

  /**
   * What a line is about.
   *
   * @param drone its number, from 1; empty for what concerns all of them, or the window
   * @param subject whether the drone is the subject that the words lack
   */
  record About(OptionalInt drone, boolean subject) {

    /** All drones, or the window. */
    static final About ALL = new About(OptionalInt.empty(), false);

    /**
     * A drone.
     *
     * @param drone its number, from 1
     */
    static About drone(int drone, boolean subject) {
      return new About(OptionalInt.of(drone), subject);
    }
  }

  /**
   * What a line says about a command.
   *
   * @param command as it was sent
   * @param outcome empty where it arrived
   */
  record Exchange(Peer peer, String command, Optional<Outcome> outcome) {

    /** The command, for people. */
    String printable() {
      return WireText.printable(command);
    }

    /** Whether an answer is still to come. */
    boolean open() {
      return outcome.isEmpty() && !WireText.isUnanswered(command);
    }

    private static Exchange of(SimEvent.FromPeer event, String reply, Optional<Phrase> reason) {
      Outcome outcome = new Outcome(WireText.printable(reply.stripTrailing()), reason);
      return new Exchange(event.peer(), event.text(), Optional.of(outcome));
    }
  }

  /**
   * What became of a command.
   *
   * @param reply what the drone answered, for people
   * @param reason why it was refused or came to another end; empty if all was well
   */
  record Outcome(String reply, Optional<Phrase> reason) {}

  /** Something that can be said in each language. */
  @FunctionalInterface
  interface Saying {
    String in(Language language);
  }

  /** What happened in the simulation. */
  static LogLine of(SimEvent event) {
    return new LogLine(
        event.time(),
        LogLevel.of(event.severity()),
        event instanceof SimEvent.ForDrone one
            ? About.drone(one.drone(), one.lacksSubject())
            : About.ALL,
        language -> language.say(event.phrase()),
        exchange(event));
  }

  private static Optional<Exchange> exchange(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived received) {
      return Optional.of(new Exchange(received.peer(), received.text(), Optional.empty()));
    }
    if (event instanceof SimEvent.ReplySent sent) {
      return Optional.of(Exchange.of(sent, sent.reply().text(), Optional.empty()));
    }
    if (event instanceof SimEvent.CommandRefused refused) {
      return Optional.of(
          Exchange.of(refused, refused.reply().text(), Optional.of(refused.reason())));
    }
    if (event instanceof SimEvent.CommandFailed failed) {
      return Optional.of(Exchange.of(failed, failed.reply().text(), Optional.of(failed.reason())));
    }
    return Optional.empty();
  }

  /** See {@link About}. */
  OptionalInt drone() {
    return about.drone();
  }

  /** For people, without time, level and drone. */
  String words(Language language) {
    return saying.in(language);
  }
}
