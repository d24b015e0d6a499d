package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.view.log.LogLine.About;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;

/**
 * Queue of lines for the log, which the window drains once a pulse. For any thread; nobody who
 * writes ever waits. What finds no room is counted, and a line says how much that was.
 */
public final class LogQueue implements SimListener {

  /**
   * Lines that may wait. Decided: ten times what a pulse brings when one drone, at the highest time
   * factor, is asked as fast as loopback can.
   */
  static final int CAPACITY = 10_000;

  private final Queue<LogLine> waiting = new ArrayBlockingQueue<>(CAPACITY);
  private final AtomicLong lost = new AtomicLong();
  private final AtomicBoolean welcomed = new AtomicBoolean();
  private volatile SimTime now = SimTime.ZERO;

  /** Only for the JavaFX thread. */
  private List<LogLine> shownBefore = List.of();

  @Override
  public void event(SimEvent event) {
    add(LogLine.of(event));
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    now = snapshot.time();
  }

  /**
   * Writes a line of the window itself.
   *
   * @param key of a text in this package's messages
   * @param values for the places in the text
   */
  void note(LogLevel level, String key, Object... values) {
    add(noted(level, About.ALL, key, values));
  }

  /**
   * Writes what the window has to say of a drone, with a subject of its own.
   *
   * @param drone its number, from 1
   */
  public void say(LogLevel level, int drone, Phrase phrase) {
    add(new LogLine(now, level, About.drone(drone, false), language -> language.say(phrase)));
  }

  /**
   * Writes a sentence of others.
   *
   * @param saying makes it in each language
   */
  public void say(LogLevel level, Function<Language, String> saying) {
    add(new LogLine(now, level, About.ALL, saying::apply));
  }

  /**
   * Greets, the first time.
   *
   * @param on whether all drones are on already
   */
  void welcome(boolean on) {
    if (welcomed.compareAndSet(false, true)) {
      note(LogLevel.INFO, on ? "welcome.on" : "welcome");
    }
  }

  /** Takes back what a log showed; the next one shows it first. */
  void takeBack(List<LogLine> lines) {
    shownBefore = List.copyOf(lines);
  }

  /** Says why a drone stays off. */
  public void cannotSwitchOn(int drone, PortTakenException refusal) {
    add(
        noted(
            LogLevel.ERROR,
            About.drone(drone, true),
            "port." + refusal.obstacle().name(),
            refusal.address().getPort(),
            refusal.address().getAddress().getHostAddress()));
  }

  /** Takes what waits, oldest first. */
  List<LogLine> drain() {
    List<LogLine> lines = new ArrayList<>(shownBefore);
    shownBefore = List.of();
    long missing = lost.getAndSet(0);
    for (int i = 0; i < CAPACITY; i++) {
      LogLine line = waiting.poll();
      if (line == null) {
        break;
      }
      lines.add(line);
    }
    if (missing > 0) {
      lines.add(noted(LogLevel.WARN, About.ALL, missing == 1 ? "lost-one" : "lost", missing));
    }
    return lines;
  }

  private LogLine noted(LogLevel level, About about, String key, Object... values) {
    return new LogLine(
        now, level, about, language -> language.messages(LogQueue.class).now(key, values));
  }

  private void add(LogLine line) {
    if (!waiting.offer(line)) {
      lost.incrementAndGet();
    }
  }
}
