package tellosimulator.scenario;

import tellosimulator.math.Pose;

/**
 * A drone with a planned start. Immutable.
 *
 * @param start the planned pose on the floor, in the room frame
 */
public record PlannedDrone(DroneOrigin origin, Pose start) {

  /** Returns a copy of this drone with another start. */
  public PlannedDrone at(Pose newStart) {
    return new PlannedDrone(origin, newStart);
  }
}
