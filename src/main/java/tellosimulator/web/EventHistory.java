package tellosimulator.web;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.sim.LogLimiter;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/** The latest events of a simulation, for the log of pages. Thread-safe. */
public final class EventHistory {

  /** Number of events that are kept. Decided: some pages of the log. */
  private static final int KEPT = 200;

  private final Deque<SimEvent> events = new ArrayDeque<>();
  private long count;

  /** Returns the listener, which leaves out reads and {@code rc}, and what comes too often. */
  SimListener limited() {
    return new LogLimiter(
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            if (event.severity() != Severity.DETAIL) {
              add(event);
            }
          }
        });
  }

  private synchronized void add(SimEvent event) {
    events.addLast(event);
    count++;
    if (events.size() > KEPT) {
      events.removeFirst();
    }
  }

  /** Returns the number of events so far. */
  synchronized long count() {
    return count;
  }

  /** Returns those of the latest events that came after the first {@code shown}. */
  synchronized List<SimEvent> after(long shown) {
    long skipped = Math.max(0, shown - (count - events.size()));
    return events.stream().skip(skipped).toList();
  }

  static Map<String, Object> members(SimEvent event, WebTexts texts) {
    return Json.object(
        "time", Json.rounded(event.time().seconds()),
        "level", event.severity().name().toLowerCase(Locale.ROOT),
        "drone", event instanceof SimEvent.ForDrone one ? one.drone() : null,
        "text", texts.say(event.phrase()));
  }
}
