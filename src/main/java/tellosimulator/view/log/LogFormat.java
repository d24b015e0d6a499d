package tellosimulator.view.log;

import java.util.Locale;
import java.util.stream.Collectors;
import javafx.beans.value.ObservableValue;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** Formats the lines and rows of the log, and their parts. Confined to the JavaFX thread. */
final class LogFormat {

  private final Language language;
  private final Messages messages;
  private final boolean severalDrones;

  /**
   * @param severalDrones whether there are several drones, so that lines must contain the number of
   *     their drone
   */
  LogFormat(Language language, boolean severalDrones) {
    this.language = language;
    this.messages = language.messages(LogFormat.class);
    this.severalDrones = severalDrones;
  }

  String time(LogLine line) {
    return String.format(language.locale(), "%.3f s", line.time().seconds());
  }

  /** Returns the tooltip of a line's time. It changes with the language of the window. */
  ObservableValue<String> timeHint() {
    return messages.text("time.tooltip");
  }

  /**
   * Returns the name of the line's drone; empty if there is only one drone, or if the line is not
   * about a single drone.
   */
  String drone(LogLine line) {
    return severalDrones && line.drone().isPresent()
        ? messages.now("drone", line.drone().getAsInt())
        : "";
  }

  /**
   * Returns the words of a line. If they lack a grammatical subject, and no name of a drone is
   * shown before them, a subject is added.
   */
  String words(LogLine line) {
    String words = line.words(language);
    boolean incomplete = line.about().subject() && !severalDrones;
    return incomplete ? messages.now("sentence", words) : words;
  }

  /** Returns the command of a row, or the words of its line if the row is not about a command. */
  String words(LogRow row) {
    return row.command().orElseGet(() -> words(row.first()));
  }

  /**
   * Returns the drone's reply, or an ellipsis while it is pending; empty if no reply is expected,
   * or if the row is not about a command.
   */
  String reply(LogRow row) {
    boolean waits = row.first().exchange().filter(LogLine.Exchange::open).isPresent();
    return row.outcome().map(LogLine.Outcome::reply).orElse(waits ? "…" : "");
  }

  /** Returns the duration of the command; empty if it is unknown, or while the reply is pending. */
  String duration(LogRow row) {
    return row.duration().isPresent()
        ? String.format(language.locale(), "%.2f s", row.duration().getAsDouble())
        : "";
  }

  /** Returns the reason why the command was refused or failed; empty on success. */
  String reason(LogRow row) {
    return row.outcome().flatMap(LogLine.Outcome::reason).map(language::say).orElse("");
  }

  /** Returns all parts of a row as one text for screen readers. */
  String spoken(LogRow row) {
    return String.join(" ", drone(row.first()), words(row), reply(row), duration(row), reason(row))
        .strip();
  }

  /** Returns the searchable text of a row: all its lines without their times. */
  String searched(LogRow row) {
    return row.lines().stream().map(this::searched).collect(Collectors.joining("\n"));
  }

  private String searched(LogLine line) {
    String drone = drone(line);
    return drone.isEmpty() ? words(line) : drone + " " + words(line);
  }

  /** Returns all lines of a row, each with its time. */
  String details(LogRow row) {
    return row.lines().stream()
        .map(line -> time(line) + "  " + searched(line))
        .collect(Collectors.joining("\n"));
  }

  /**
   * Returns a line with its time, level and drone, for a file or the clipboard. Times and levels
   * are aligned across lines.
   */
  String whole(LogLine line) {
    String drone = drone(line);
    return String.format(
        Locale.ROOT,
        "%12s  %-5s  %s%s",
        time(line),
        line.level(),
        drone.isEmpty() ? "" : drone + ": ",
        words(line));
  }
}
