package tellosimulator.sensor;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/** Where the beams of a drone's distance sensors come back from. */
public interface Echoes {

  /**
   * How far it is from a drone's feet to what is below, along its own axis [m]; infinite if it
   * looks up.
   */
  double below(Pose drone);

  /**
   * How far it is to the nearest thing along a beam [m].
   *
   * @param origin room frame [m]
   * @param direction unit vector, room frame
   */
  double along(Vec3 origin, Vec3 direction);
}
