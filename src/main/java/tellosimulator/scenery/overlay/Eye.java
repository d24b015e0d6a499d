package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;

/**
 * From where people look at an overlay. Immutable.
 *
 * @param pose of the camera, room frame; it looks along its x axis
 * @param nearest nearer things are clipped [m]
 */
public record Eye(Pose pose, double nearest) {

  /**
   * How far from the camera one shows what is in front of everything in the room [m]: so near that
   * nothing is nearer, and the farther, the farther what is shown is.
   *
   * @param distance of what is shown [m]
   */
  double beforeAll(double distance) {
    return nearest * (2 + distance / (1 + distance));
  }

  /**
   * The same for what is in front of the room, but behind what is in front of everything [m].
   *
   * @param distance of what is shown [m]
   */
  double beforeRoom(double distance) {
    return 2 * beforeAll(distance);
  }
}
