package tellosimulator.view.log;

import java.util.Locale;
import java.util.stream.Collectors;
import javafx.beans.value.ObservableValue;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** How a line of the log is written, part by part and as a whole. For the JavaFX thread. */
final class LogFormat {

  private final Language language;
  private final Messages messages;
  private final boolean severalDrones;

  /**
   * @param severalDrones whether lines must say which drone they are about
   */
  LogFormat(Language language, boolean severalDrones) {
    this.language = language;
    this.messages = language.messages(LogFormat.class);
    this.severalDrones = severalDrones;
  }

  String time(LogLine line) {
    return String.format(language.locale(), "%.3f s", line.time().seconds());
  }

  /** What the time of a line is, in the language that is chosen. */
  ObservableValue<String> timeHint() {
    return messages.text("time.tooltip");
  }

  /** Which drone it is about; empty if there is only one, or if it is about all of them. */
  String drone(LogLine line) {
    return severalDrones && line.drone().isPresent()
        ? messages.now("drone", line.drone().getAsInt())
        : "";
  }

  /** What happened; where no drone is named, as a sentence with a subject. */
  String words(LogLine line) {
    String words = line.words(language);
    boolean incomplete = line.about().subject() && !severalDrones;
    return incomplete ? messages.now("sentence", words) : words;
  }

  /** The command of a row, or what happened. */
  String words(LogRow row) {
    return row.command().orElseGet(() -> words(row.first()));
  }

  /** What the drone answered; empty if nothing is to be answered, or it is about no command. */
  String reply(LogRow row) {
    boolean waits = row.first().exchange().filter(LogLine.Exchange::open).isPresent();
    return row.outcome().map(LogLine.Outcome::reply).orElse(waits ? "…" : "");
  }

  /** How long the command took; empty if that is not known. */
  String duration(LogRow row) {
    return row.duration().isPresent()
        ? String.format(language.locale(), "%.2f s", row.duration().getAsDouble())
        : "";
  }

  /** Why the command was refused or came to another end; empty if all was well. */
  String reason(LogRow row) {
    return row.outcome().flatMap(LogLine.Outcome::reason).map(language::say).orElse("");
  }

  /** A row as a sentence, for those who hear it. */
  String spoken(LogRow row) {
    return String.join(" ", drone(row.first()), words(row), reply(row), duration(row), reason(row))
        .strip();
  }

  /** What a search looks at: all that its lines say but for the time. */
  String searched(LogRow row) {
    return row.lines().stream().map(this::searched).collect(Collectors.joining("\n"));
  }

  private String searched(LogLine line) {
    String drone = drone(line);
    return drone.isEmpty() ? words(line) : drone + " " + words(line);
  }

  /** All lines of a row, each with its time. */
  String details(LogRow row) {
    return row.lines().stream()
        .map(line -> time(line) + "  " + searched(line))
        .collect(Collectors.joining("\n"));
  }

  /** All of it, for a file or another program; the columns of all lines are aligned. */
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
