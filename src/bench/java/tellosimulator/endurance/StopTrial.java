package tellosimulator.endurance;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/**
 * Processes that the system does not let run for some seconds, as of a computer that is asleep or
 * short of memory: the simulator in flight, and then the client, whose sockets fill up with film.
 */
final class StopTrial {

  private static final double STOPPED_SECONDS = 5;

  /** So much state is sent in a second. */
  private static final int LINES = 10;

  /** What a simulator that hurries may catch up at once; 5 s would be 50 lines. */
  private static final int MOST_MORE_LINES = 4;

  private static final double WATCHED_SECONDS = 5;
  private static final double PATIENCE_SECONDS = 90;
  private static final int RETRY_MS = 7000;

  /** What may pass in the simulation between two looks at the clock and a signal [s]. */
  private static final double TOLERANCE_SECONDS = 1;

  private static final double QUERY_SECONDS = 0.1;
  private static final int QUERY_MS = 1000;

  private StopTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    TourProcess.Ports ports =
        new TourProcess.Ports(
            Host.HERE.address(), FreePort.find(), FreePort.find(), FreePort.find());
    List<Measurement> rows = new ArrayList<>();
    try (SimulatorProcess simulator = SimulatorProcess.here(ports.options())) {
      try (TourProcess tours = new TourProcess(Host.HERE, ports, RETRY_MS)) {
        tours.awaitFlying(PATIENCE_SECONDS);
        rows.addAll(stopSimulator(simulator, tours));
        rows.addAll(stopClient(simulator, tours));
      }
      rows.add(LeakedInternals.row("… log", simulator));
      rows.add(Health.row("… after that", simulator));
    }
    return rows;
  }

  private static List<Measurement> stopSimulator(SimulatorProcess simulator, TourProcess tours)
      throws IOException {
    double before = simulator.simulatedSeconds();
    long begun = System.nanoTime();
    signal("STOP", simulator.program());
    Waiting.pass(STOPPED_SECONDS);
    OtherLoad others = new OtherLoad();
    long continued = System.nanoTime();
    signal("CONT", simulator.program());
    TourProcess.Window first = tours.window(continued, 1);
    TourProcess.Window later = tours.window(continued + 1_000_000_000L, WATCHED_SECONDS);
    double after = simulator.simulatedSeconds();
    double ran = (System.nanoTime() - begun) * 1e-9 - STOPPED_SECONDS;
    double share = others.share();
    int again = tours.awaitFlown(PATIENCE_SECONDS);
    return List.of(
        new Measurement(
            "Simulator stopped in flight for 5 s (SIGSTOP): state lines in the second after that",
            "at most " + (LINES + MOST_MORE_LINES),
            first.state().count() + " of 10",
            first.state().count() <= LINES + MOST_MORE_LINES),
        OtherLoad.judged(
            Measurement.atMost("… until the first one", 500, first.state().firstMs()), share),
        OtherLoad.judged(statePeriod(later.state()), share),
        new Measurement(
            "… simulated time",
            "does not jump",
            String.format(Locale.ROOT, "%.1f s in %.1f s without the stop", after - before, ran),
            after - before <= ran + TOLERANCE_SECONDS),
        Measurement.beside("… a client flies on", again + " commands sent again"));
  }

  private static List<Measurement> stopClient(SimulatorProcess simulator, TourProcess tours)
      throws IOException {
    double before = simulator.simulatedSeconds();
    OtherLoad others = new OtherLoad();
    long begun = System.nanoTime();
    signal("STOP", tours.program());
    int asked = 0;
    int answered = 0;
    for (double end = STOPPED_SECONDS * 2; (System.nanoTime() - begun) * 1e-9 < end; asked++) {
      answered += answers(simulator) ? 1 : 0;
      Waiting.pass(QUERY_SECONDS);
    }
    double simulated = simulator.simulatedSeconds() - before;
    double seconds = (System.nanoTime() - begun) * 1e-9;
    long continued = System.nanoTime();
    signal("CONT", tours.program());
    TourProcess.Window later = tours.window(continued + 1_000_000_000L, WATCHED_SECONDS);
    int again = tours.awaitFlown(PATIENCE_SECONDS);
    double share = others.share();
    return List.of(
        OtherLoad.judged(
            new Measurement(
                "Client stopped for 10 s, with film: simulator answers others",
                "all",
                answered + " of " + asked,
                answered == asked),
            share),
        OtherLoad.judged(
            new Measurement(
                "… simulated time",
                "passes as before",
                String.format(Locale.ROOT, "%.1f s in %.1f s", simulated, seconds),
                Math.abs(simulated - seconds) <= TOLERANCE_SECONDS),
            share),
        OtherLoad.judged(statePeriod(later.state()), share),
        new Measurement(
            "… pictures after that",
            "come",
            later.video().count() + " datagrams in 5 s",
            later.video().count() > 0),
        Measurement.beside("… the client flies on", again + " commands sent again in all"));
  }

  /** At the pace of the drone's own time. */
  static Measurement statePeriod(Arrivals.Figures states) {
    double period = states.periodMs();
    return new Measurement(
        "… state lines, mean period",
        "100 ms ± 2",
        String.format(Locale.ROOT, "%.2f ms", period),
        Math.abs(period - 100) <= 2);
  }

  private static boolean answers(SimulatorProcess simulator) throws IOException {
    try (Operator stranger = new Operator(simulator.drone(1).getPort(), QUERY_MS)) {
      return !stranger.ask("battery?").isEmpty();
    } catch (SocketTimeoutException e) {
      return false;
    }
  }

  private static void signal(String name, Program to) throws IOException {
    Host.HERE.run("kill", "-" + name, "" + to.process().pid());
  }
}
