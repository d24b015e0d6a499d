package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;

/**
 * A translucent instance of the overlay, which is drawn before those that are nearer. Immutable.
 *
 * @param distance from the camera [m]; lower than that of all others if it is in front of them
 */
record Marker(Instance instance, double distance) {

  /** Larger than any distance in a room [m]. */
  private static final double FAR = 1e6;

  /** Something at a place of the room. */
  static Marker at(Vec3 place, Instance instance, Eye eye) {
    return new Marker(instance, eye.pose().position().distanceTo(place));
  }

  /**
   * Something that is drawn in front of all that is at places of the room.
   *
   * @param distance of what it is about [m]
   */
  static Marker inFront(Instance instance, double distance) {
    return new Marker(instance, distance - 2 * FAR);
  }

  /**
   * Something that is drawn in front of the room, but not of what is in front of all.
   *
   * @param distance of what it is about [m]
   */
  static Marker beforeRoom(Instance instance, double distance) {
    return new Marker(instance, distance - FAR);
  }
}
