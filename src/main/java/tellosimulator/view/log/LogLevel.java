package tellosimulator.view.log;

import java.util.Locale;
import org.kordamp.ikonli.feather.Feather;
import tellosimulator.sim.Severity;

/** How much a line of the log matters, and how that is shown; the most important first. */
public enum LogLevel {
  ERROR(Severity.ERROR, Feather.X_OCTAGON),
  WARN(Severity.WARNING, Feather.ALERT_TRIANGLE),
  INFO(Severity.INFORMATION, Feather.INFO),
  DEBUG(Severity.DETAIL, Feather.CODE);

  private final Severity severity;
  private final Feather icon;

  LogLevel(Severity severity, Feather icon) {
    this.severity = severity;
    this.icon = icon;
  }

  /** The level of something that happened. */
  static LogLevel of(Severity severity) {
    for (LogLevel level : values()) {
      if (level.severity == severity) {
        return level;
      }
    }
    throw new IllegalArgumentException("severity is " + severity + ", which has no level");
  }

  /** Whether it matters as much as {@code least}, or more. */
  boolean reaches(LogLevel least) {
    return compareTo(least) <= 0;
  }

  Feather icon() {
    return icon;
  }

  /** Its name in style classes and keys of texts. */
  String key() {
    return name().toLowerCase(Locale.ROOT);
  }
}
