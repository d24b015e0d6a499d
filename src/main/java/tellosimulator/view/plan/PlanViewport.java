package tellosimulator.view.plan;

import tellosimulator.math.Vec3;
import tellosimulator.world.Room;

/**
 * From the floor to the screen: the room's x points up, its y to the left. Immutable.
 *
 * @param middle the place of the floor in the middle of the screen [m]
 * @param pixels for a metre
 * @param width of the screen [px]
 * @param height of the screen [px]
 */
record PlanViewport(Vec3 middle, double pixels, double width, double height) {

  /** What is left free around the room [px]. */
  private static final double MARGIN = 34;

  /** Most pixels for a metre. Decided: a pad as large as a hand. */
  private static final double CLOSEST = 600;

  /** A scale at which all of the room is seen. */
  static PlanViewport whole(Room room, double width, double height) {
    double pixels =
        Math.min((width - 2 * MARGIN) / room.width(), (height - 2 * MARGIN) / room.depth());
    return new PlanViewport(Vec3.ZERO, Math.max(0.1, Math.min(CLOSEST, pixels)), width, height);
  }

  /** The same for a screen of another size. */
  PlanViewport sized(double newWidth, double newHeight) {
    return new PlanViewport(middle, pixels, newWidth, newHeight);
  }

  double screenX(Vec3 place) {
    return width / 2 - (place.y() - middle.y()) * pixels;
  }

  double screenY(Vec3 place) {
    return height / 2 - (place.x() - middle.x()) * pixels;
  }

  /** The place of the floor under a point of the screen. */
  Vec3 place(double x, double y) {
    return middle.plus(new Vec3((height / 2 - y) / pixels, (width / 2 - x) / pixels, 0));
  }

  /** What a distance on the screen is on the floor [m]. */
  double meters(double distance) {
    return distance / pixels;
  }

  /** The same moved by a hand, by some pixels to the right and down. */
  PlanViewport dragged(double right, double down) {
    return new PlanViewport(
        middle.plus(new Vec3(down / pixels, right / pixels, 0)), pixels, width, height);
  }

  /** Nearer by a factor, with the place under a point of the screen where it is. */
  PlanViewport zoomed(double factor, double x, double y) {
    double wanted = Math.max(0.1, Math.min(CLOSEST, pixels * factor));
    Vec3 under = place(x, y);
    Vec3 kept = under.plus(middle.minus(under).times(pixels / wanted));
    return new PlanViewport(kept, wanted, width, height);
  }
}
