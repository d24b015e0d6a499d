package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;

/**
 * A translucent instance in the overlay. Farther items are drawn before nearer ones. Immutable.
 *
 * @param distance distance from the camera [m]; for an item drawn in front of the room, a negative
 *     sort key; the key is lower than the keys of all items behind the item
 */
record OverlayItem(Instance instance, double distance) {

  /** A distance larger than any in a room [m]. */
  private static final double FAR = 1e6;

  /** Returns an item at a place in the room. */
  static OverlayItem at(Vec3 place, Instance instance, Eye eye) {
    return new OverlayItem(instance, eye.pose().position().distanceTo(place));
  }

  /**
   * The layers in front of the room, from back to front. The layers of drones are in front of the
   * layers of goals, because drones matter more.
   */
  enum Layer {
    GOALS(1),
    GOAL_TAGS(2),
    RINGS(3),
    CONTACTS(4),
    DRONE_TAGS(5);

    /** The number of layers. */
    private static final int COUNT = 5;

    /**
     * Distance of the foremost layer from the camera, as a multiple of the distance of the near
     * clipping plane.
     */
    private static final double FOREMOST = 1.6;

    /** Ratio between the distances of adjacent layers. */
    private static final double STEP = 1.35;

    /**
     * Relative depth of a layer. Within a layer, farther items are drawn farther away. The depth
     * must be less than the gap between layers.
     */
    private static final double DEPTH = 0.15;

    /** Position of the layer, from 1 for the rearmost one. */
    private final int place;

    Layer(int place) {
      this.place = place;
    }

    /**
     * Returns the distance from the camera at which an item of this layer is drawn [m]. It is so
     * small that hardly anything in the room is nearer. It increases with the distance of the
     * item's subject, but stays less than the distances in the layer behind.
     *
     * @param distance distance of the subject from the camera [m]
     */
    double distance(double distance, Eye eye) {
      double farther = 1 + DEPTH * distance / (1 + distance);
      return eye.nearest() * FOREMOST * StrictMath.pow(STEP, COUNT - place) * farther;
    }
  }

  /**
   * Returns an item that is drawn in front of the room.
   *
   * @param distance distance of the subject from the camera [m]
   */
  static OverlayItem inFront(Layer layer, Instance instance, double distance) {
    return new OverlayItem(instance, distance - layer.place * FAR);
  }
}
