package tellosimulator.junit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Describes what happened in a test, in words. */
final class FlightExplanation {

  private FlightExplanation() {}

  /**
   * Returns an explanation: the last commands, the states of the drones and the goals, then the
   * journals.
   */
  static String of(TelloSimulator simulator) {
    List<String> lines = new ArrayList<>();
    simulator.drones().forEach(drone -> lines.add(lastCommand(drone)));
    simulator.drones().forEach(drone -> lines.add(state(drone)));
    lines.add("goals: " + simulator.simulation().goals());
    for (SimulatedDrone drone : simulator.drones()) {
      lines.add("");
      lines.add("what came to " + drone + ":");
      lines.add(drone.journal().toString());
    }
    return String.join(System.lineSeparator(), lines);
  }

  private static String lastCommand(SimulatedDrone drone) {
    List<JournalEntry> entries = drone.journal().entries();
    if (entries.isEmpty()) {
      return String.format(
          Locale.ROOT,
          "last command to %s: none; did the program start, and does it send to %s:%d?",
          drone,
          drone.host(),
          drone.commandPort());
    }
    return "last command to " + drone + ": " + entries.get(entries.size() - 1).toString().strip();
  }

  private static String state(SimulatedDrone drone) {
    DroneTruth truth = drone.truth();
    StringBuilder line = new StringBuilder();
    line.append(
        String.format(
            Locale.ROOT,
            "%s: %s at %s, heading %.0f degrees, battery %d %%; ",
            drone,
            phase(truth),
            truth.position(),
            truth.heading(),
            truth.battery()));
    line.append(
        switch (truth.takeoffs()) {
          case 0 -> "never took off";
          case 1 -> "took off once";
          default -> "took off " + truth.takeoffs() + " times";
        });
    if (truth.takeoffs() > 0) {
      line.append(
          String.format(
              Locale.ROOT,
              ", was up to %.0f cm high and %.0f cm from its start",
              truth.highest(),
              truth.farthest()));
    }
    if (!truth.touched().isEmpty()) {
      line.append(
          truth.touched().stream()
              .map(FlightExplanation::touch)
              .collect(Collectors.joining(", ", "; ", "")));
    }
    return line.toString();
  }

  static String phase(DroneTruth truth) {
    return truth.flying() ? "flies" : truth.crashed() ? "lies crashed" : "stands";
  }

  static String touch(DroneTruth.Touch touch) {
    return String.format(
        Locale.ROOT,
        "%s %s at %.1f s with %.0f cm/s",
        touch.crash() ? "crashed into" : "touched",
        touch.what(),
        touch.seconds(),
        touch.speed());
  }
}
