package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** What an operator program sees of the runnable jar on the same machine. */
final class WireBenchmark {

  private static final int DRONES = 11;
  private static final int RC_PERIOD_MS = 50;

  private static final int WARM_UP_QUERIES = 20_000;

  private static final int QUERIES = 20_000;
  private static final int STATE_LINES = 600;

  /** More than have arrived during the takeoff and wait in the socket. */
  private static final int WAITING_STATE_LINES = 50;

  private static final int STARTS = 11;

  private WireBenchmark() {}

  /**
   * Queries to one drone while ten others are steered by {@code rc}.
   *
   * @param filming whether one of the ten also films
   */
  static List<Measurement> queries(boolean filming) throws IOException {
    try (VideoSocket video = new VideoSocket();
        Simulator simulator =
            new Simulator(
                "--video-port",
                "" + video.port(),
                "--drones",
                "" + DRONES,
                "--port-per-drone",
                "--bind",
                "127.0.0.1",
                "--room",
                "2000x2000x500",
                "--command-port",
                "18879",
                "--log-level",
                "warn");
        Operator withChallenge = new Operator(simulator.port(DRONES));
        Steering steering = new Steering(simulator)) {
      withChallenge.expect("command", "ok");
      steering.start();
      if (filming) {
        film(simulator.port(1), video);
      }
      for (int i = 0; i < WARM_UP_QUERIES; i++) {
        withChallenge.ask("battery?");
      }
      List<Double> times = new ArrayList<>();
      for (int i = 0; i < QUERIES; i++) {
        long start = System.nanoTime();
        withChallenge.ask("battery?");
        times.add((System.nanoTime() - start) * 1e-6);
      }
      Statistics statistics = new Statistics(times);
      return List.of(
          Measurement.atMost(
              "Query round trip beside 10 drones on `rc`" + addition(filming) + ", median",
              0.15,
              statistics.median()),
          Measurement.atMost("… 99th percentile", 1, statistics.quantile(0.99)));
    }
  }

  private static void film(int port, VideoSocket video) throws IOException {
    try (Operator operator = new Operator(port)) {
      operator.expect("streamon", "ok");
      video.awaitKeyPicture();
    }
  }

  private static String addition(boolean filming) {
    return filming ? " while one films" : "";
  }

  /**
   * The distance in time of state lines that arrive, and beside it that of a plain timer.
   *
   * @param filming whether the drone also films
   */
  static List<Measurement> stateLines(boolean filming) throws IOException {
    try (DatagramSocket states = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        VideoSocket video = new VideoSocket();
        Simulator simulator =
            new Simulator(
                "--command-port",
                "0",
                "--state-port",
                "" + states.getLocalPort(),
                "--video-port",
                "" + video.port());
        Operator operator = new Operator(simulator.port(1))) {
      operator.expect("command", "ok");
      operator.expect("takeoff", "ok");
      if (filming) {
        film(simulator.port(1), video);
      }
      Statistics plain;
      List<Double> periods = new ArrayList<>();
      DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
      for (int i = 0; i < WAITING_STATE_LINES; i++) {
        states.receive(packet);
      }
      try (PlainTimer timer = new PlainTimer()) {
        long last = System.nanoTime();
        for (int i = 0; i < STATE_LINES; i++) {
          if (i % 100 == 0) {
            operator.send("cw 90");
          }
          states.receive(packet);
          long now = System.nanoTime();
          periods.add((now - last) * 1e-6);
          last = now;
        }
        plain = timer.periods();
      }
      Statistics statistics = new Statistics(periods);
      double mean = statistics.mean();
      return List.of(
          new Measurement(
              "State lines in real time" + addition(filming) + ", mean period",
              "100 ms ± 0.5",
              milliseconds(mean),
              Math.abs(mean - 100) <= 0.5),
          Measurement.atMost("… standard deviation", 1, statistics.deviation()),
          Measurement.beside(
              "… of a thread that only waits, at the same time", milliseconds(plain.deviation())));
    }
  }

  /** From the start of the process to its first line, and its memory then. */
  static List<Measurement> start() throws IOException {
    List<Double> seconds = new ArrayList<>();
    List<Double> megabytes = new ArrayList<>();
    for (int i = 0; i < STARTS; i++) {
      try (Simulator simulator = new Simulator("--command-port", "0")) {
        seconds.add(simulator.startSeconds());
        megabytes.add(simulator.figures().residentMegabytes());
      }
    }
    double start = new Statistics(seconds).median();
    double memory = new Statistics(megabytes).quantile(1);
    return List.of(
        new Measurement(
            "From the start of the JVM to `ready`, median of " + STARTS,
            "at most 0.5 s",
            String.format(Locale.ROOT, "%.2f s", start),
            start <= 0.5),
        memory("Resident memory at `ready`, largest of " + STARTS, memory));
  }

  /** Memory after a long flight of one drone in real time. */
  static List<Measurement> memoryAfter(double minutes) throws IOException {
    try (Simulator simulator = new Simulator("--command-port", "0");
        Operator operator = new Operator(simulator.port(1))) {
      operator.expect("command", "ok");
      long end = System.nanoTime() + (long) (minutes * 60e9);
      while (System.nanoTime() < end) {
        Tour.fly(operator);
      }
      return List.of(
          memory(
              String.format(Locale.ROOT, "Resident memory after %.0f minutes of flight", minutes),
              simulator.figures().residentMegabytes()));
    }
  }

  private static Measurement memory(String what, double megabytes) {
    return new Measurement(
        what, "at most 120 MB", String.format(Locale.ROOT, "%.0f MB", megabytes), megabytes <= 120);
  }

  private static String milliseconds(double value) {
    return String.format(Locale.ROOT, "%.3f ms", value);
  }

  /** Ten drones in the air that get {@code rc} twenty times a second. */
  private static final class Steering implements AutoCloseable {

    private final List<Operator> operators = new ArrayList<>();
    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
    private int turn;

    Steering(Simulator simulator) throws IOException {
      for (int drone = 1; drone < DRONES; drone++) {
        operators.add(new Operator(simulator.port(drone)));
      }
    }

    void start() {
      CompletableFuture.allOf(
              operators.stream()
                  .map(operator -> CompletableFuture.runAsync(() -> takeOff(operator)))
                  .toArray(CompletableFuture[]::new))
          .join();
      var unused = timer.scheduleAtFixedRate(this::steer, 0, RC_PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    private static void takeOff(Operator operator) {
      try {
        operator.expect("command", "ok");
        operator.expect("takeoff", "ok");
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    private void steer() {
      turn++;
      String command = turn / 40 % 2 == 0 ? "rc 0 30 0 20" : "rc 0 -30 0 -20";
      try {
        for (Operator operator : operators) {
          operator.send(command);
        }
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    @Override
    public void close() {
      timer.shutdownNow();
      operators.forEach(Operator::close);
    }
  }
}
