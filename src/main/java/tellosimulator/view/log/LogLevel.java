package tellosimulator.view.log;

import java.util.Locale;
import org.kordamp.ikonli.feather.Feather;
import tellosimulator.sim.Severity;

/** The levels of the log's lines, in order of decreasing importance. Each level has an icon. */
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

  /** Returns the level for the severity of an event. */
  static LogLevel of(Severity severity) {
    for (LogLevel level : values()) {
      if (level.severity == severity) {
        return level;
      }
    }
    throw new IllegalArgumentException("severity is " + severity + ", which has no level");
  }

  /** Returns whether this level is at least as important as {@code least}. */
  boolean reaches(LogLevel least) {
    return compareTo(least) <= 0;
  }

  Feather icon() {
    return icon;
  }

  /** Returns the name used in style classes and message keys. */
  String key() {
    return name().toLowerCase(Locale.ROOT);
  }
}
