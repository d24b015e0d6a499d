package tellosimulator.endurance;

import java.io.IOException;
import java.util.regex.Pattern;
import tellosimulator.benchmark.Measurement;

/** What nobody should read in a log: names of classes, and places in the code. */
final class LeakedInternals {

  private static final Pattern INTERNALS =
      Pattern.compile(
          "Exception|Error\\b|\\bat [\\w.$]+\\([\\w.]+|java\\.(lang|io|util)|please report");

  private LeakedInternals() {}

  /** The first line that speaks of the program's insides; empty if there is none. */
  static String first(String text) {
    return text.lines().filter(line -> INTERNALS.matcher(line).find()).findFirst().orElse("");
  }

  static Measurement row(String what, SimulatorProcess simulator) throws IOException {
    String found = first(simulator.program().log());
    return new Measurement(what, "no exception", found.isEmpty() ? "none" : found, found.isEmpty());
  }
}
