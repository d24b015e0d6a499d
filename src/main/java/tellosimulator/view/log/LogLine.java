package tellosimulator.view.log;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import tellosimulator.command.Request;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;

/**
 * A line of the log. Immutable; its words are created for each language on demand.
 *
 * @param time the simulated time
 * @param about the subject of the line
 * @param saying creates the words
 * @param exchange the command that the line is about, and its outcome; empty if the line is not
 *     about a command, or if the drone ignored or never received the command
 */
record LogLine(
    SimTime time,
    LogLevel level,
    About about,
    Function<Language, String> saying,
    Optional<Exchange> exchange) {

  /** Creates a line that is not about a command. */
  LogLine(SimTime time, LogLevel level, About about, Function<Language, String> saying) {
    this(time, level, about, saying, Optional.empty());
  }

  /**
   * The subject of a line.
   *
   * @param drone the number of the drone, from 1; empty for all drones or the window
   * @param subject whether the words lack their grammatical subject, the drone
   */
  record About(OptionalInt drone, boolean subject) {

    /** The subject of lines about all drones, or about the window. */
    static final About ALL = new About(OptionalInt.empty(), false);

    /**
     * Returns the subject of a line about one drone.
     *
     * @param drone the number of the drone, from 1
     */
    static About drone(int drone, boolean subject) {
      return new About(OptionalInt.of(drone), subject);
    }
  }

  /**
   * The command that a line is about, and its outcome.
   *
   * @param request the command
   * @param outcome the outcome; empty if the line reports the arrival of the command
   */
  record Exchange(Request request, Optional<Outcome> outcome) {

    /** Returns the printable text of the command. */
    String printable() {
      return WireText.printable(request.text());
    }

    /** Returns whether a reply is still expected. */
    boolean open() {
      return outcome.isEmpty() && !WireText.isUnanswered(request.text());
    }

    private static Exchange of(SimEvent.OfCommand event, String reply, Optional<Phrase> reason) {
      Outcome outcome = new Outcome(WireText.printable(reply.stripTrailing()), reason);
      return new Exchange(event.request(), Optional.of(outcome));
    }
  }

  /**
   * The outcome of a command.
   *
   * @param reply the printable reply of the drone
   * @param reason the reason why the command was refused or failed; empty on success
   */
  record Outcome(String reply, Optional<Phrase> reason) {}

  /** Returns the line for an event of the simulation. */
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
      return Optional.of(new Exchange(received.request(), Optional.empty()));
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

  /** Returns the number of the drone, from 1; empty if the line is not about a single drone. */
  OptionalInt drone() {
    return about.drone();
  }

  /** Returns the words without time, level and drone. */
  String words(Language language) {
    return saying.apply(language);
  }
}
