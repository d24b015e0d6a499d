package tellosimulator.scenery.overlay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.Marker.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The numbers of goals over their places, white on a rounded square, or a tick for those that are
 * reached. Walls do not hide them. For one thread.
 */
public final class GoalTags {

  /** Edge of the tag that comes next, as a share of the distance from the camera. Decided. */
  public static final double SIZE = DroneTag.SIZE;

  /** How much smaller than others are those of goals that come later. Decided. */
  private static final double LATER = 0.8;

  /** The same of those that are done: they shall not cover what still matters. Decided. */
  private static final double DONE = 0.6;

  /** Height above a circle on which one lands [m]. Decided: clear of a drone that stands there. */
  private static final double ABOVE_CIRCLE = 0.3;

  /** Edge of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final List<Point> TICK =
      List.of(new Point(19, 33), new Point(28, 43), new Point(46, 21));

  private record Look(int number, GoalState state, Rgb color) {}

  private final Map<Look, Billboard> billboards = new HashMap<>();

  /**
   * A tag.
   *
   * @param aside how many others are at the same place
   */
  Marker of(GoalMark mark, Rgb color, int aside, Eye eye) {
    Look look = new Look(mark.number(), mark.state(), color);
    Vec3 place = over(mark.place());
    Billboard billboard = billboards.computeIfAbsent(look, GoalTags::billboard);
    double distance = eye.pose().position().distanceTo(place);
    double near = Layer.GOAL_TAGS.distance(distance, eye);
    return Marker.inFront(
        Layer.GOAL_TAGS, billboard.inFront(place, eye.pose(), aside, near), distance);
  }

  /** Where its lower edge is. */
  private static Vec3 over(GoalMark.Place place) {
    if (place instanceof GoalMark.Ball ball) {
      return ball.middle().plusScaled(Vec3.UP, ball.radius());
    }
    if (place instanceof GoalMark.Opening opening) {
      return opening.top();
    }
    return place.middle().plusScaled(Vec3.UP, ABOVE_CIRCLE);
  }

  private static Billboard billboard(Look look) {
    double factor =
        switch (look.state) {
          case ACTIVE -> 1;
          case LATER -> LATER;
          case DONE -> DONE;
        };
    return Billboard.standing(texture(look), SIZE * factor);
  }

  private static Texture texture(Look look) {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(look.color, mask -> square(mask, 27))
        .paint(
            Rgb.WHITE,
            mask -> {
              if (look.state == GoalState.DONE) {
                mask.stroke(TICK, 7);
              } else {
                DroneTag.write(mask, look.number);
              }
            })
        .cutOut(square(new AlphaMask(TEXELS), 31));
  }

  /** A square with round corners. */
  private static AlphaMask square(AlphaMask mask, double reach) {
    double middle = TEXELS / 2.0;
    double round = 9;
    double near = middle - reach + round;
    double far = middle + reach - round;
    List<Point> corners =
        List.of(
            new Point(near, near), new Point(far, near), new Point(far, far), new Point(near, far));
    List<Point> closed =
        List.of(corners.get(0), corners.get(1), corners.get(2), corners.get(3), corners.get(0));
    return mask.fill(corners).stroke(closed, 2 * round);
  }
}
