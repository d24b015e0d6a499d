package tellosimulator.benchmark;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * A thread that does nothing but wake up ten times a second. How evenly it does tells what the
 * machine does to everybody who waits for a moment.
 */
final class PlainTimer implements AutoCloseable {

  private static final int PERIOD_MS = 100;

  private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
  private final List<Double> periods = new ArrayList<>();
  private long last;

  /** Begins at once. */
  PlainTimer() {
    var unused = timer.scheduleAtFixedRate(this::tick, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
  }

  private synchronized void tick() {
    long now = System.nanoTime();
    if (last != 0) {
      periods.add((now - last) * 1e-6);
    }
    last = now;
  }

  /** From each time to the next, up to now [ms]. */
  synchronized Statistics periods() {
    return new Statistics(periods);
  }

  @Override
  public void close() {
    timer.shutdownNow();
  }
}
