package tellosimulator.sensor;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/** The surroundings as the distance sensors of a drone detect them. */
public interface Echoes {

  /**
   * Returns the distance from a drone's feet to the object below [m], measured along the drone's
   * own vertical axis; infinite if the sensor points up.
   */
  double below(Pose drone);

  /**
   * Returns the distance to the nearest object along a beam [m].
   *
   * @param origin the start of the beam, in the room frame [m]
   * @param direction a unit vector, in the room frame
   */
  double along(Vec3 origin, Vec3 direction);
}
