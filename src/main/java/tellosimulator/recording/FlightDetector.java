package tellosimulator.recording;

import java.util.Optional;
import tellosimulator.controller.FlightEvent;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;

/**
 * Detects where a flight of a simulation begins and ends: from a first takeoff until all drones
 * have been down for three seconds, or are down when one of them is reset or switched off. For the
 * simulation thread.
 */
final class FlightDetector {

  /** How long all drones must be down before a flight is over [s]. Decided. */
  private static final double REST = 3;

  private boolean flying;
  private Optional<SimTime> down = Optional.empty();

  /** Whether there is a flight that has not ended yet. */
  boolean flying() {
    return flying;
  }

  /** Takes in an event; returns whether a flight begins with it. */
  boolean begins(SimEvent event) {
    boolean begins =
        !flying
            && event instanceof SimEvent.DroneFlight flight
            && flight.event() instanceof FlightEvent.TookOff;
    if (begins) {
      flying = true;
      down = Optional.empty();
    }
    return begins;
  }

  /**
   * Whether the flight ends with an event, after which nothing of it follows.
   *
   * @param snapshot the drones when it happened
   */
  boolean ends(SimEvent event, SimSnapshot snapshot) {
    return flying
        && event instanceof SimEvent.DroneFlight flight
        && (flight.event() instanceof FlightEvent.PutBack
            || phase(snapshot, flight.drone()) == FlightPhase.OFF)
        && allDown(snapshot);
  }

  /** Takes in a step; returns whether the flight ends with it. For each step that is looked at. */
  boolean ends(SimSnapshot snapshot) {
    if (!allDown(snapshot)) {
      down = Optional.empty();
      return false;
    }
    SimTime since = down.orElse(snapshot.time());
    down = Optional.of(since);
    return flying && snapshot.time().since(since) >= REST;
  }

  /** There is no flight any more. */
  void end() {
    flying = false;
  }

  private static FlightPhase phase(SimSnapshot snapshot, int drone) {
    return snapshot.drones().get(drone - 1).state().phase();
  }

  private static boolean allDown(SimSnapshot snapshot) {
    for (SimSnapshot.DroneSnapshot drone : snapshot.drones()) {
      FlightPhase phase = drone.state().phase();
      if (phase.flying() || phase == FlightPhase.FALLING) {
        return false;
      }
    }
    return true;
  }
}
