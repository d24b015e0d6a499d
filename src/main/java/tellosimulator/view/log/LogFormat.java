package tellosimulator.view.log;

import java.util.Locale;
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

  /** What a search looks at: all that is shown but for the time. */
  String searched(LogLine line) {
    String drone = drone(line);
    return drone.isEmpty() ? words(line) : drone + " " + words(line);
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
