package tellosimulator.sensor;

import tellosimulator.math.Pose;

/** What a drone stands on or flies over. */
@FunctionalInterface
public interface Ground {

  /** A floor at height 0, and nothing on it. */
  Ground FLOOR =
      drone -> {
        double down = drone.attitude().up().z();
        return down > 0 ? drone.position().z() / down : Double.POSITIVE_INFINITY;
      };

  /**
   * How far it is from a drone's feet to what is below, along its own axis [m]; infinite if it
   * looks up.
   */
  double below(Pose drone);
}
