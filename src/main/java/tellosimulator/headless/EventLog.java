package tellosimulator.headless;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/** Writes what happens to the log, at the level that its {@link Severity} gives it. */
final class EventLog implements SimListener {

  private static final Logger LOG = LoggerFactory.getLogger("tellosimulator.event");

  @Override
  public void event(SimEvent event) {
    LOG.atLevel(level(event.severity())).log("{}", lineOf(event));
  }

  private static Level level(Severity severity) {
    return switch (severity) {
      case ERROR -> Level.ERROR;
      case WARNING -> Level.WARN;
      case INFORMATION -> Level.INFO;
      case DETAIL -> Level.DEBUG;
    };
  }

  /** Formats only if the line is really written. */
  private static Object lineOf(SimEvent event) {
    return new Object() {
      @Override
      public String toString() {
        return event.line();
      }
    };
  }
}
