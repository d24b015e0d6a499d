package tellosimulator.endurance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/** A script's simulator, which must not keep the script waiting. */
final class EndingTrial {

  private static final double LONGEST_SECONDS = 5;
  private static final double PATIENCE_SECONDS = 180;
  private static final int MISSED = 3;

  private static final String SCENARIO = "goals:\n  - reach: {at: [200, 200, 200], radius: 10}\n";

  private EndingTrial() {}

  /** A program that lands without its goals, and then is gone. */
  static List<Measurement> landsTooEarly(double minutes) throws IOException {
    try (SimulatorProcess simulator = start()) {
      try (Operator operator = new Operator(simulator.drone(1).getPort())) {
        operator.expect("command", "ok");
        operator.expect("takeoff", "ok");
        operator.expect("land", "ok");
      }
      return ending("--exit-when-done: from landing without the goals to the end", simulator);
    }
  }

  /** A program that is gone after its first word. */
  static List<Measurement> neverTakesOff(double minutes) throws IOException {
    try (SimulatorProcess simulator = start("--timeout", "60")) {
      try (Operator operator = new Operator(simulator.drone(1).getPort())) {
        operator.expect("command", "ok");
      }
      return ending("--timeout 60: a program that never takes off ends after", simulator);
    }
  }

  private static List<Measurement> ending(String what, SimulatorProcess simulator)
      throws IOException {
    long begun = System.nanoTime();
    String result = simulator.program().await("goals", PATIENCE_SECONDS);
    int code = simulator.program().awaitExit(PATIENCE_SECONDS);
    double seconds = (System.nanoTime() - begun) * 1e-9;
    return List.of(
        new Measurement(
            what,
            String.format(Locale.ROOT, "at most %.0f s", LONGEST_SECONDS),
            String.format(Locale.ROOT, "%.1f s", seconds),
            seconds <= LONGEST_SECONDS),
        new Measurement(
            "… exit code, and a reason",
            "3, `goals: … : …`",
            code + ", `" + result + "`",
            code == MISSED && result.matches("goals: .*: .+")));
  }

  private static SimulatorProcess start(String... more) throws IOException {
    Path scenario = Files.writeString(Files.createTempFile("goals", ".yaml"), SCENARIO);
    List<String> options = new ArrayList<>(List.of("--command-port", "0", "--exit-when-done"));
    options.addAll(List.of("--time-factor", "max", "--scenario", scenario.toString()));
    options.addAll(List.of(more));
    return SimulatorProcess.here(options.toArray(String[]::new));
  }
}
