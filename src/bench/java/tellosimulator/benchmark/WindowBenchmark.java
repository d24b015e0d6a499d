package tellosimulator.benchmark;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;

/** What somebody sees who has the window open, and what an operator program sees then. */
final class WindowBenchmark {

  private static final String[] NOT_ON_THE_USUAL_PORTS = {
    "--bind", "127.0.0.1", "--command-port", "0", "--state-port", "9"
  };

  private static final int STARTS = 5;
  private static final int FLIGHT_SECONDS = 45;

  /** The first ten seconds are for warming up. */
  private static final int WARM_UP_PERIODS = 1;

  private static final int WARM_UP_QUERIES = 5_000;
  private static final int QUERIES = 10_000;

  /** Longest start of a window that can be used [s]. Source of these targets: issue 19. */
  private static final double LONGEST_START = 2.5;

  /** Fewest frames a second in the default room, and in the gate race. */
  private static final double LEAST_FRAMES = 24;

  private static final double LEAST_RACE_FRAMES = 20;

  private static final int SWARM = 20;
  private static final double LEAST_SWARM_FRAMES = 15;

  private WindowBenchmark() {}

  /** Everything, or why nothing of it can be measured here. */
  static List<Measurement> all(double minutes) throws IOException {
    if (System.getenv("DISPLAY") == null) {
      return List.of(new Measurement("The window", "see above", "not measured: no display", false));
    }
    List<Measurement> rows = new ArrayList<>();
    rows.add(start());
    rows.add(
        frames("Window of 1280 × 800 with one drone flying and the log scrolling", LEAST_FRAMES));
    rows.add(frames("… in scenario `gate-race`", LEAST_RACE_FRAMES, "--scenario", "gate-race"));
    rows.add(swarmFrames());
    rows.addAll(queries());
    rows.add(heapAfter(minutes));
    return rows;
  }

  /** Pauses of 10 ms between two refused commands, so that the log takes ten a second. */
  private static final int PAUSES = 10;

  /** From the start of the process to a window that can be used. */
  private static Measurement start() throws IOException {
    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < STARTS; i++) {
      try (Simulator simulator = Simulator.inFirstWindow(NOT_ON_THE_USUAL_PORTS)) {
        seconds.add(simulator.usableSeconds());
      }
    }
    double median = new Statistics(seconds).median();
    return new Measurement(
        "From the start of the JVM to a window that can be used, median of " + STARTS,
        "at most " + LONGEST_START + " s",
        String.format(Locale.ROOT, "%.2f s", median),
        median <= LONGEST_START);
  }

  /** One drone that flies by {@code rc}, and refused commands that let the log scroll. */
  private static Measurement frames(String what, double least, String... scenario)
      throws IOException {
    List<String> options = new ArrayList<>(List.of(NOT_ON_THE_USUAL_PORTS));
    options.addAll(List.of(scenario));
    try (Simulator simulator = Simulator.inWindow(options.toArray(String[]::new));
        Operator operator = new Operator(simulator.port(1));
        Circling circling = new Circling(simulator.port(1))) {
      operator.expect("command", "ok");
      operator.expect("takeoff", "ok");
      circling.start();
      long end = System.nanoTime() + FLIGHT_SECONDS * 1_000_000_000L;
      while (System.nanoTime() < end) {
        operator.expect("forward 5", "out of range");
        for (int i = 0; i < PAUSES; i++) {
          LockSupport.parkNanos(10_000_000);
        }
      }
      List<Double> rates = simulator.frameRates();
      double median = new Statistics(rates.subList(WARM_UP_PERIODS, rates.size())).median();
      return new Measurement(
          what,
          String.format(Locale.ROOT, "at least %.0f frames/s", least),
          String.format(Locale.ROOT, "%.1f frames/s", median),
          median >= least);
    }
  }

  /** Twenty drones side by side that fly by {@code rc}, all of them at once. */
  private static Measurement swarmFrames() throws IOException {
    List<String> options = new ArrayList<>(List.of(NOT_ON_THE_USUAL_PORTS));
    options.addAll(List.of("--port-per-drone", "--drones", "" + SWARM, "--room", "1000x1000x300"));
    List<Circling> flying = new ArrayList<>();
    try (Simulator simulator = Simulator.inWindow(options.toArray(String[]::new))) {
      for (int drone = 1; drone <= SWARM; drone++) {
        try (Operator operator = new Operator(simulator.port(drone))) {
          operator.expect("command", "ok");
          operator.send("takeoff");
        }
        Circling circling = new Circling(simulator.port(drone));
        flying.add(circling);
        circling.start();
      }
      long end = System.nanoTime() + FLIGHT_SECONDS * 1_000_000_000L;
      while (System.nanoTime() < end) {
        LockSupport.parkNanos(10_000_000);
      }
      List<Double> rates = simulator.frameRates();
      double median = new Statistics(rates.subList(WARM_UP_PERIODS, rates.size())).median();
      return new Measurement(
          "… with " + SWARM + " drones flying",
          "at least 15 frames/s",
          String.format(Locale.ROOT, "%.1f frames/s", median),
          median >= LEAST_SWARM_FRAMES);
    } finally {
      flying.forEach(Circling::close);
    }
  }

  /** Queries while the window shows a drone that flies. */
  private static List<Measurement> queries() throws IOException {
    try (Simulator simulator = Simulator.inWindow(NOT_ON_THE_USUAL_PORTS);
        Operator operator = new Operator(simulator.port(1));
        Circling circling = new Circling(simulator.port(1))) {
      operator.expect("command", "ok");
      operator.expect("takeoff", "ok");
      circling.start();
      for (int i = 0; i < WARM_UP_QUERIES; i++) {
        operator.ask("battery?");
      }
      List<Double> times = new ArrayList<>();
      for (int i = 0; i < QUERIES; i++) {
        long start = System.nanoTime();
        operator.ask("battery?");
        times.add((System.nanoTime() - start) * 1e-6);
      }
      Statistics statistics = new Statistics(times);
      return List.of(
          Measurement.atMost(
              "Query round trip with the window open, median", 0.3, statistics.median()),
          Measurement.atMost("… 99th percentile", 5, statistics.quantile(0.99)));
    }
  }

  /** Growth of the used heap over a long flight with state and log. */
  private static Measurement heapAfter(double minutes) throws IOException {
    try (Simulator simulator = Simulator.inWindow(NOT_ON_THE_USUAL_PORTS);
        Operator operator = new Operator(simulator.port(1))) {
      operator.expect("command", "ok");
      Tour.fly(operator);
      double before = simulator.figures().heapMegabytes();
      long end = System.nanoTime() + (long) (minutes * 60e9);
      while (System.nanoTime() < end) {
        Tour.fly(operator);
      }
      double growth = simulator.figures().heapMegabytes() - before;
      return new Measurement(
          String.format(
              Locale.ROOT, "Growth of the used heap in %.0f minutes in the window", minutes),
          "at most 10 MB",
          String.format(Locale.ROOT, "%.1f MB, from %.0f MB", growth, before),
          growth <= 10);
    }
  }
}
