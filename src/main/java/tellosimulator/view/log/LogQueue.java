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
 * A bounded queue of lines for the log. The window drains it once per pulse. Thread-safe; writers
 * never block. Lines that do not fit are dropped; the next {@link #drain} reports their number in
 * an additional line.
 */
public final class LogQueue implements SimListener {

  /**
   * Maximum number of waiting lines. Decided: ten times the number that arrives per pulse when one
   * drone, at the highest time factor, receives commands as fast as loopback allows.
   */
  static final int CAPACITY = 10_000;

  private final Queue<LogLine> waiting = new ArrayBlockingQueue<>(CAPACITY);
  private final AtomicLong lost = new AtomicLong();
  private final AtomicBoolean welcomed = new AtomicBoolean();
  private volatile SimTime now = SimTime.ZERO;

  /**
   * The lines of the previous log. The next log shows them before any other lines. Confined to the
   * JavaFX thread.
   */
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
   * Adds a line about the window itself.
   *
   * @param key the key of a text in this package's messages
   * @param values the arguments of the text
   */
  void note(LogLevel level, String key, Object... values) {
    add(noted(level, About.ALL, key, values));
  }

  /**
   * Adds a line about a drone. The phrase must contain its grammatical subject.
   *
   * @param drone the number of the drone, from 1
   */
  public void say(LogLevel level, int drone, Phrase phrase) {
    add(new LogLine(now, level, About.drone(drone, false), language -> language.say(phrase)));
  }

  /**
   * Adds a line with any text.
   *
   * @param saying creates the text for a language
   */
  public void say(LogLevel level, Function<Language, String> saying) {
    add(new LogLine(now, level, About.ALL, saying));
  }

  /**
   * Adds a welcome line on the first call; later calls have no effect.
   *
   * @param on whether all drones are already on
   */
  void welcome(boolean on) {
    if (welcomed.compareAndSet(false, true)) {
      note(LogLevel.INFO, on ? "welcome.on" : "welcome");
    }
  }

  /** Takes back the lines of a closed log. The next log shows them first. */
  void takeBack(List<LogLine> lines) {
    shownBefore = List.copyOf(lines);
  }

  /** Adds a line with the reason why a drone stays off. */
  public void cannotSwitchOn(int drone, PortTakenException refusal) {
    add(
        noted(
            LogLevel.ERROR,
            About.drone(drone, true),
            "port." + refusal.obstacle().name(),
            refusal.address().getPort(),
            refusal.address().getAddress().getHostAddress()));
  }

  /** Removes and returns the waiting lines, oldest first. Called on the JavaFX thread. */
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
