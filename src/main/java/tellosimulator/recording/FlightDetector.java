package tellosimulator.recording;

import java.util.Optional;
import tellosimulator.controller.FlightEvent;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;

/**
 * Detects the beginning and end of a simulated flight. A flight begins with the first takeoff. It
 * ends when all drones have been on the ground for three seconds, or when a drone is reset or
 * switched off while all are on the ground. Confined to the simulation thread.
 */
final class FlightDetector {

  /** How long all drones must have been on the ground before a flight ends [s]. Decided. */
  private static final double REST = 3;

  private boolean flying;
  private Optional<SimTime> down = Optional.empty();

  /** Whether a flight is in progress. */
  boolean flying() {
    return flying;
  }

  /** Processes an event; returns whether it begins a flight. */
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
   * Returns whether an event ends the flight; later events do not belong to the flight.
   *
   * @param snapshot the drones at the time of the event
   */
  boolean ends(SimEvent event, SimSnapshot snapshot) {
    return flying
        && event instanceof SimEvent.DroneFlight flight
        && (flight.event() instanceof FlightEvent.PutBack
            || phase(snapshot, flight.drone()) == FlightPhase.OFF)
        && allDown(snapshot);
  }

  /**
   * Processes a sampled step; returns whether it ends the flight. Must be called for each sampled
   * step.
   */
  boolean ends(SimSnapshot snapshot) {
    if (!allDown(snapshot)) {
      down = Optional.empty();
      return false;
    }
    SimTime since = down.orElse(snapshot.time());
    down = Optional.of(since);
    return flying && snapshot.time().since(since) >= REST;
  }

  /** Marks the flight as ended. */
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
