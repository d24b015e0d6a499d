package tellosimulator.scenery.overlay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.PlacedGoal.PlaceCases;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.OverlayItem.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The tags above the places of goals. Each tag is a rounded square with the number of the goal in
 * white, or with a white tick if the goal has been reached. Walls do not hide the tags. Not
 * thread-safe.
 */
public final class GoalTags {

  /**
   * Side length of the next goal's tag, as a fraction of the distance from the camera. Decided: the
   * same as for the tag of a drone.
   */
  public static final double SIZE = DroneTag.SIZE;

  /**
   * Scale of the tags of later goals. Decided: they stand out less than the tag of the next goal.
   */
  private static final double LATER = 0.8;

  /**
   * Scale of the tags of completed goals. Decided: they do not cover tags of goals that are still
   * to be reached.
   */
  private static final double DONE = 0.6;

  /**
   * Height of a tag above a landing circle, and at least above the middle of a square [m]. Decided:
   * clear of a drone that stands on the circle.
   */
  private static final double ABOVE_CIRCLE = 0.3;

  /** Side length of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final List<Point> TICK =
      List.of(new Point(19, 33), new Point(28, 43), new Point(46, 21));

  private record TagKey(int number, GoalState state, Rgb color) {}

  private final Map<TagKey, Billboard> billboards = new HashMap<>();

  /**
   * Returns the tag of a goal.
   *
   * @param aside number of tags of other goals at the same place that are to the left of this tag
   */
  OverlayItem of(PlacedGoal mark, Rgb color, int aside, Eye eye) {
    TagKey look = new TagKey(mark.number(), mark.state(), color);
    Vec3 place = over(mark.place());
    Billboard billboard = billboards.computeIfAbsent(look, GoalTags::billboard);
    double distance = eye.pose().position().distanceTo(place);
    double near = Layer.GOAL_TAGS.distance(distance, eye);
    return OverlayItem.inFront(
        Layer.GOAL_TAGS, billboard.inFront(place, eye.pose(), aside, near), distance);
  }

  /** Returns the position of the tag's lower edge. */
  private static Vec3 over(PlacedGoal.Place place) {
    return place.match(
        new PlaceCases<>(
            ball -> ball.middle().plusScaled(Vec3.UP, ball.radius()),
            circle -> circle.middle().plusScaled(Vec3.UP, ABOVE_CIRCLE),
            PlacedGoal.Opening::top,
            square ->
                square.middle().plusScaled(Vec3.UP, Math.max(ABOVE_CIRCLE, 0.6 * square.edge()))));
  }

  private static Billboard billboard(TagKey look) {
    double factor =
        switch (look.state) {
          case ACTIVE -> 1;
          case LATER -> LATER;
          case DONE -> DONE;
        };
    return Billboard.standing(texture(look), SIZE * factor);
  }

  private static Texture texture(TagKey look) {
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

  /** Draws a square with rounded corners. */
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
