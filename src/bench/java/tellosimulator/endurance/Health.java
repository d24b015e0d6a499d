package tellosimulator.endurance;

import java.io.IOException;
import java.util.regex.Pattern;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/** Whether a simulator on this machine works as a whole, or has ended as a whole. */
final class Health {

  /** How long a simulator may be deaf after an attack [s]. */
  private static final double PATIENCE_SECONDS = 10;

  private static final int TRY_MS = 500;

  private static final Pattern NUMBER = Pattern.compile("\\d+\\s*");

  private Health() {}

  /** The simulator must go on to work. */
  static Measurement row(String what, SimulatorProcess simulator) throws IOException {
    boolean alive = answers(simulator);
    return new Measurement(what, "answers", alive ? "answers" : "is deaf", alive);
  }

  /** The simulator must work, or have ended with a sentence. */
  static Measurement rowOfWhole(String what, SimulatorProcess simulator) throws IOException {
    String wanted = "works, or ended with a sentence";
    if (answers(simulator)) {
      String insides = LeakedInternals.first(simulator.program().log());
      return new Measurement(
          what, wanted, insides.isEmpty() ? "works" : "works, but " + insides, insides.isEmpty());
    }
    if (!simulator.program().endsWithin(PATIENCE_SECONDS)) {
      return new Measurement(what, wanted, "half dead: " + lastLine(simulator), false);
    }
    int code = simulator.program().process().exitValue();
    boolean told =
        code != 0 && code < 128 && LeakedInternals.first(simulator.program().log()).isEmpty();
    return new Measurement(what, wanted, "ended with " + code + ": " + lastLine(simulator), told);
  }

  private static String lastLine(SimulatorProcess simulator) throws IOException {
    return simulator
        .program()
        .log()
        .lines()
        .reduce((first, second) -> second)
        .orElse("without a word");
  }

  /** Whether the drone answers within some seconds, and the console too. */
  static boolean answers(SimulatorProcess simulator) throws IOException {
    long end = System.nanoTime() + (long) (PATIENCE_SECONDS * 1e9);
    while (System.nanoTime() < end
        && simulator.drone(1) != null
        && simulator.program().process().isAlive()) {
      try (Operator operator = new Operator(simulator.drone(1).getPort(), TRY_MS)) {
        operator.send("command");
        operator.send("battery?");
        while (!NUMBER.matcher(operator.receive()).matches()) {
          // The reply to `command`, or a late one.
        }
        return simulator.state(1).startsWith("drone 1");
      } catch (IOException e) {
        Waiting.pass(Waiting.SHORT);
      }
    }
    return false;
  }
}
