package tellosimulator.scenario;

import tellosimulator.math.Pose;

/**
 * A drone where somebody wants it to start. Immutable; for any thread.
 *
 * @param start on the floor, room frame
 */
public record PlannedDrone(DroneOrigin origin, Pose start) {

  /** The same elsewhere. */
  public PlannedDrone at(Pose newStart) {
    return new PlannedDrone(origin, newStart);
  }
}
