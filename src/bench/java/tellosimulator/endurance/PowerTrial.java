package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/** The power switch, and the program itself, off and on again and again. */
final class PowerTrial {

  private static final int CYCLES_A_MINUTE = 200;
  private static final int MOST_CYCLES = 1000;
  private static final int STARTS_A_MINUTE = 4;
  private static final int MOST_STARTS = 200;

  private static final double LARGEST_GROWTH_MB = 5;
  private static final int REPLY_MS = 5000;

  private PowerTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    rows.addAll(cycles((int) Math.min(MOST_CYCLES, minutes * CYCLES_A_MINUTE)));
    rows.add(starts((int) Math.min(MOST_STARTS, minutes * STARTS_A_MINUTE)));
    return rows;
  }

  private static List<Measurement> cycles(int cycles) throws IOException {
    int port = FreePort.find();
    try (SimulatorProcess simulator = SimulatorProcess.here("--command-port", "" + port)) {
      int good = 0;
      cycle(simulator, port);
      double heap = simulator.figures().heapMegabytes();
      int threads = simulator.figures().threads();
      for (int i = 0; i < cycles; i++) {
        good += cycle(simulator, port) ? 1 : 0;
      }
      int moreThreads = simulator.figures().threads() - threads;
      return List.of(
          all("Power cycles after which the drone answers", cycles, good),
          Measurement.atMost(
              "… heap grows by",
              LARGEST_GROWTH_MB,
              simulator.figures().heapMegabytes() - heap,
              "MB"),
          new Measurement("… threads more", "at most 2", "" + moreThreads, moreThreads <= 2),
          LeakedInternals.row("… log", simulator));
    }
  }

  /**
   * Whether the drone is deaf while it is off, which the console has waited for, and then answers.
   */
  private static boolean cycle(SimulatorProcess simulator, int port) throws IOException {
    simulator.type("power off");
    simulator.type("power on");
    return answers(port);
  }

  private static boolean answers(int port) {
    try (Operator operator = new Operator(port, REPLY_MS)) {
      operator.expect("command", "ok");
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Starts on one port; each start is killed in flight. */
  private static Measurement starts(int starts) throws IOException {
    int port = FreePort.find();
    int good = 0;
    for (int i = 0; i < starts; i++) {
      try (SimulatorProcess simulator = SimulatorProcess.here("--command-port", "" + port);
          Operator operator = new Operator(port, REPLY_MS)) {
        operator.expect("command", "ok");
        operator.send("takeoff");
        operator.send("streamon");
        good++;
        simulator.program().kill();
      } catch (IOException e) {
        System.out.println("start " + i + ": " + e.getMessage());
      }
    }
    return all("Starts on one port, each killed in flight, that were ready", starts, good);
  }

  private static Measurement all(String what, int wanted, int good) {
    return new Measurement(what, "all of " + wanted, good + " of " + wanted, good == wanted);
  }
}
