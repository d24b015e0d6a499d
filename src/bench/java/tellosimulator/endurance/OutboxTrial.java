package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/** Queries that wait for their replies' delay, which does not pass while the simulation rests. */
final class OutboxTrial {

  private static final int RATE = 50_000;
  private static final double LARGEST_HEAP_MB = 10;
  private static final double SHORTEST_SECONDS = 10;
  private static final double SECONDS_A_MINUTE = 2;
  private static final double PATIENCE_SECONDS = 20;

  private OutboxTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    double seconds = Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE);
    try (SimulatorProcess simulator =
            SimulatorProcess.here("--command-port", "0", "--fault", "delay replies 40ms");
        Operator operator = new Operator(simulator.drone(1).getPort())) {
      operator.expect("command", "ok");
      simulator.type("pause");
      double heap = simulator.figures().heapMegabytes();
      double resident = simulator.figures().residentMegabytes();
      try (Program withChallenge =
          Host.HERE.start(
              Stranger.class,
              Host.HERE.address(),
              simulator.drone(1).getPort(),
              RATE,
              seconds,
              Host.HERE.address(),
              "battery?")) {
        withChallenge.await("sent", seconds + PATIENCE_SECONDS);
      }
      double residentGrowth = simulator.figures().residentMegabytes() - resident;
      double heapGrowth = simulator.figures().heapMegabytes() - heap;
      simulator.type("resume");
      List<Measurement> rows = new ArrayList<>();
      rows.add(
          Measurement.atMost(
              "Queries flood a paused drone on a slow link: heap grows by",
              LARGEST_HEAP_MB,
              heapGrowth,
              "MB"));
      rows.add(
          Measurement.beside(
              "… resident memory, with what the collector has not looked at yet",
              String.format(Locale.ROOT, "%.0f MB", residentGrowth)));
      rows.add(Health.row("… after that", simulator));
      return rows;
    }
  }
}
