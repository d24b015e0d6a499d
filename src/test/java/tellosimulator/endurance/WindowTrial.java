package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Row;
import tellosimulator.benchmark.Statistics;

/** What the window costs while nothing moves. */
final class WindowTrial {

  private static final double LARGEST_PERCENT = 5;
  private static final double WARM_UP_SECONDS = 10;
  private static final double SECONDS = 5;
  private static final int TIMES = 3;

  private WindowTrial() {}

  static List<Row> run(double minutes) throws IOException {
    String what = "The window while nothing moves, median of " + TIMES;
    if (System.getenv("DISPLAY") == null) {
      return List.of(Row.beside(what, "not measured: no display"));
    }
    try (SimulatorProcess simulator =
        SimulatorProcess.inWindow("--command-port", "0", "--state-port", "" + FreePort.find())) {
      Moments.pass(WARM_UP_SECONDS);
      List<Double> percents = new ArrayList<>();
      for (int i = 0; i < TIMES; i++) {
        double before = simulator.figures().processorSeconds();
        long begun = System.nanoTime();
        Moments.pass(SECONDS);
        double used = simulator.figures().processorSeconds() - before;
        percents.add(100 * used / ((System.nanoTime() - begun) * 1e-9));
      }
      double median = new Statistics(percents).median();
      return List.of(
          new Row(
              what,
              String.format(Locale.ROOT, "at most %.0f %% of a processor", LARGEST_PERCENT),
              String.format(Locale.ROOT, "%.1f %%", median),
              median <= LARGEST_PERCENT));
    }
  }
}
