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

  /** What is in front of the room, from behind to before: a drone matters more than a goal. */
  enum Layer {
    GOALS(1),
    GOAL_TAGS(2),
    RINGS(3),
    CONTACTS(4),
    DRONE_TAGS(5);

    /** How many layers there are. */
    private static final int COUNT = 5;

    /** How far the layer that is before all others is shown, in the nearest distance that is. */
    private static final double FOREMOST = 1.6;

    /** From a layer to the next one behind it. */
    private static final double STEP = 1.35;

    /** How much farther things of one layer are shown that are farther; less than a step. */
    private static final double DEPTH = 0.15;

    /** Its place, from 1 for the one that is behind all others. */
    private final int place;

    Layer(int place) {
      this.place = place;
    }

    /**
     * How far from the camera one shows what is in this layer [m]: so near that hardly anything of
     * the room is nearer, and the farther, the farther what it is about is. Each is nearer than all
     * of the layer behind it.
     *
     * @param distance of what it is about [m]
     */
    double distance(double distance, Eye eye) {
      double farther = 1 + DEPTH * distance / (1 + distance);
      return eye.nearest() * FOREMOST * StrictMath.pow(STEP, COUNT - place) * farther;
    }
  }

  /**
   * Something that is drawn in front of the room.
   *
   * @param distance of what it is about [m]
   */
  static Marker inFront(Layer layer, Instance instance, double distance) {
    return new Marker(instance, distance - layer.place * FAR);
  }
}
