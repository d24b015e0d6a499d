package tellosimulator.headless;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.CommandSyntax;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/**
 * Writes what happens to the log: commands, replies and flights as information, refusals as
 * warnings, and what comes by the dozen (reads and {@code rc}) for debugging.
 */
public final class EventLog implements SimListener {

  private static final Logger LOG = LoggerFactory.getLogger("tellosimulator.event");

  private static final String STEERING = CommandSyntax.RC.verb() + " ";

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.CommandRefused
        || event instanceof SimEvent.CommandFailed
        || event instanceof SimEvent.CommandIgnored) {
      LOG.warn("{}", lineOf(event));
    } else if (frequent(event)) {
      LOG.debug("{}", lineOf(event));
    } else {
      LOG.info("{}", lineOf(event));
    }
  }

  private static boolean frequent(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived received) {
      return frequent(received.text());
    }
    return event instanceof SimEvent.ReplySent sent && frequent(sent.text());
  }

  private static boolean frequent(String text) {
    return text.endsWith("?") || text.startsWith(STEERING);
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
