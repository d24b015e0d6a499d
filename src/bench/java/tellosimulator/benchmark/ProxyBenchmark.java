package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the proxy adds to the round trip of a query: direct and through it, in turns. */
final class ProxyBenchmark {

  private static final double TARGET_MS = 0.3;
  private static final int TURNS = 20;
  private static final int QUERIES = 500;
  private static final int WARM_UP = 5_000;

  private ProxyBenchmark() {}

  /** With a simulator in the drone's place, each program in a process of its own. */
  static List<Measurement> all() throws IOException {
    String recordings = Files.createTempDirectory("proxy").toString();
    try (Simulator drone = new Simulator("--command-port", "0", "--state-port", "9");
        Simulator proxy = Simulator.asProxy(drone.port(1), recordings);
        Operator direct = new Operator(drone.port(1));
        Operator through = new Operator(proxy.port(1))) {
      direct.expect("command", "ok");
      ask(direct, WARM_UP);
      ask(through, WARM_UP);
      List<Double> alone = new ArrayList<>();
      List<Double> passed = new ArrayList<>();
      for (int turn = 0; turn < TURNS; turn++) {
        alone.addAll(ask(direct, QUERIES));
        passed.addAll(ask(through, QUERIES));
      }
      double without = new Statistics(alone).median();
      Statistics with = new Statistics(passed);
      return List.of(
          Measurement.atMost(
              "What the proxy adds to a query's round trip, median of " + TURNS * QUERIES,
              TARGET_MS,
              with.median() - without),
          Measurement.beside("… round trip without it", milliseconds(without)),
          Measurement.beside("… round trip through it", milliseconds(with.median())),
          Measurement.beside("… 99th percentile", milliseconds(with.quantile(0.99))));
    }
  }

  private static String milliseconds(double value) {
    return String.format(Locale.ROOT, "%.3f ms", value);
  }

  private static List<Double> ask(Operator operator, int times) throws IOException {
    List<Double> taken = new ArrayList<>();
    for (int i = 0; i < times; i++) {
      long begun = System.nanoTime();
      operator.ask("battery?");
      taken.add((System.nanoTime() - begun) * 1e-6);
    }
    return taken;
  }
}
