package tellosimulator.fidelity;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import tellosimulator.fidelity.FlightLog.Line;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SteppedDrone;

/** Flies commands with simulated drones of behaviour {@code measured}, each as soon as it can. */
final class SimulatedFlights {

  /** How long a reply is waited for [s]. Decided: longer than any move. */
  private static final double PATIENCE = 30;

  /** From a reply to the next command [s]. Measured: 1 to 2 ms; it takes a step. */
  private static final double PAUSE = 0.005;

  private static final int MOST_SEEDS = 1000;

  private SimulatedFlights() {}

  /**
   * The first flights, by their seeds, in which no reply was lost on the way.
   *
   * @param count how many
   */
  static List<FlightLog> of(List<String> commands, int count) {
    List<FlightLog> flights = new ArrayList<>();
    for (long seed = 1; seed <= MOST_SEEDS && flights.size() < count; seed++) {
      flown(commands, seed).ifPresent(flights::add);
    }
    return flights;
  }

  private static Optional<FlightLog> flown(List<String> commands, long seed) {
    SteppedDrone drone =
        SteppedDrone.of(
            SimConfig.DEFAULT.withProduct(Profile.TELLO, Behavior.MEASURED).withSeed(seed));
    List<Line> lines = new ArrayList<>();
    for (String command : commands) {
      int before = drone.replies().size();
      lines.add(new Line(drone.seconds(), "command", command));
      drone.send(command);
      if (!drone.advanceUntil(() -> drone.replies().size() > before, PATIENCE)) {
        return Optional.empty();
      }
      SteppedDrone.Sent reply = drone.replies().get(before);
      lines.add(new Line(reply.seconds(), "reply", reply.text()));
      drone.advance(PAUSE);
    }
    drone.stateLines().forEach(sent -> lines.add(new Line(sent.seconds(), "state", sent.text())));
    lines.sort(Comparator.comparingDouble(Line::seconds));
    return Optional.of(new FlightLog(lines));
  }
}
