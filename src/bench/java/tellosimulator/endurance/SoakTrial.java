package tellosimulator.endurance;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;
import tellosimulator.benchmark.Tour;

/** As many hours of flight as fit into the minutes. */
final class SoakTrial {

  private static final double SHORTEST_SECONDS = 15;
  private static final double SECONDS_A_MINUTE = 5;
  private static final double LARGEST_GROWTH_MB = 5;

  /** Flights until all is loaded and all buffers have their size. */
  private static final int WARM_UP_TOURS = 100;

  private SoakTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    double seconds = Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE);
    try (SimulatorProcess simulator =
            SimulatorProcess.here("--command-port", "0", "--time-factor", "max");
        Operator operator = new Operator(simulator.drone(1).getPort())) {
      operator.expect("command", "ok");
      for (int i = 0; i < WARM_UP_TOURS; i++) {
        fly(simulator, operator);
      }
      double heap = simulator.figures().heapMegabytes();
      double before = simulator.simulatedSeconds();
      long end = System.nanoTime() + (long) (seconds * 1e9);
      while (System.nanoTime() < end) {
        fly(simulator, operator);
      }
      double hours = (simulator.simulatedSeconds() - before) / 3600;
      return List.of(
          Measurement.beside(
              "Simulated hours of flight", String.format(Locale.ROOT, "%.1f h", hours)),
          Measurement.atMost(
              "… heap grows by",
              LARGEST_GROWTH_MB,
              simulator.figures().heapMegabytes() - heap,
              "MB"),
          LeakedInternals.row("… log", simulator));
    }
  }

  private static void fly(SimulatorProcess simulator, Operator operator) throws IOException {
    simulator.program().type("battery 100");
    Tour.fly(operator);
  }
}
