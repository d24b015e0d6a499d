package tellosimulator.view.plan;

import javafx.geometry.Point2D;
import tellosimulator.math.Vec3;
import tellosimulator.world.Room;

/**
 * The transformation from the floor to the screen. The room's x axis points up, and its y axis to
 * the left. Immutable.
 *
 * @param middle the place on the floor that is in the middle of the screen [m]
 * @param pixels the scale [pixels per metre]
 * @param width the width of the screen [px]
 * @param height the height of the screen [px]
 */
record PlanViewport(Vec3 middle, double pixels, double width, double height) {

  /** Margin around the room [px]. */
  static final double MARGIN = 36;

  /** Maximum scale [pixels per metre]. Decided: a mission pad appears as large as a hand. */
  private static final double CLOSEST = 600;

  /** Returns a viewport that shows the whole room. */
  static PlanViewport whole(Room room, double width, double height) {
    double pixels =
        Math.min((width - 2 * MARGIN) / room.width(), (height - 2 * MARGIN) / room.depth());
    return new PlanViewport(Vec3.ZERO, Math.max(0.1, Math.min(CLOSEST, pixels)), width, height);
  }

  /** Returns a copy of this viewport for a screen of another size. */
  PlanViewport sized(double newWidth, double newHeight) {
    return new PlanViewport(middle, pixels, newWidth, newHeight);
  }

  double screenX(Vec3 place) {
    return width / 2 - (place.y() - middle.y()) * pixels;
  }

  double screenY(Vec3 place) {
    return height / 2 - (place.x() - middle.x()) * pixels;
  }

  /** Returns the point of the screen at which a place on the floor is shown. */
  Point2D screen(Vec3 place) {
    return new Point2D(screenX(place), screenY(place));
  }

  /** Returns the place on the floor at a point of the screen. */
  Vec3 place(double x, double y) {
    return middle.plus(new Vec3((height / 2 - y) / pixels, (width / 2 - x) / pixels, 0));
  }

  /** Converts a distance on the screen to a distance on the floor [m]. */
  double meters(double distance) {
    return distance / pixels;
  }

  /** Returns the viewport after a drag; distances are in pixels. */
  PlanViewport dragged(double right, double down) {
    return new PlanViewport(
        middle.plus(new Vec3(down / pixels, right / pixels, 0)), pixels, width, height);
  }

  /**
   * Returns a viewport that is magnified by a factor. The place at the given point of the screen
   * stays there.
   */
  PlanViewport zoomed(double factor, double x, double y) {
    double wanted = Math.max(0.1, Math.min(CLOSEST, pixels * factor));
    Vec3 under = place(x, y);
    Vec3 kept = under.plus(middle.minus(under).times(pixels / wanted));
    return new PlanViewport(kept, wanted, width, height);
  }
}
