package tellosimulator.scenery.overlay;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.PlacedGoal.PlaceCases;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.LatheMesh.Point;
import tellosimulator.scenery.overlay.LatheMesh.Range;
import tellosimulator.scenery.overlay.OverlayItem.Layer;
import tellosimulator.world.Shape;

/**
 * The markers of goals in the room. Balls mark points to reach, circles mark places to land on, and
 * frames surround what must be seen. A gate that is to be flown through next has an outline in the
 * colour of the goal, and an arrow if a direction is required. Completed gates have a green outline
 * that is so opaque that the gate's own colour does not show through. Later gates have no marker
 * except their tags. Caches the parts. Not thread-safe.
 */
final class GoalShapes {

  /**
   * Height of a circle above the surface on which it lies [m]. Decided: seen from 10 m away, the
   * circle does not flicker.
   */
  private static final double OFFSET = 0.006;

  /**
   * Height of the beacon around the next circle, as a multiple of the circle's radius. Decided: by
   * eye.
   */
  private static final double BEACON = 0.7;

  /** Length of an arrow, as a multiple of the width of the opening. Decided: by eye. */
  private static final double ARROW = 0.8;

  /**
   * Opacity of a circle that is seen through obstacles, relative to its normal opacity, 0 to 1.
   * Decided: by eye.
   */
  private static final double THROUGH_OBSTACLES = 0.4;

  /**
   * Opacity of the outline of a gate that is to be flown through next, 0 to 1. Decided: the gate's
   * segments stay visible.
   */
  private static final double GATE_AHEAD = 0.62;

  /**
   * Opacity of the outline of a completed gate, 0 to 1. Decided: the outline looks green, whatever
   * the gate's own colour is.
   */
  private static final double GATE_DONE = 0.85;

  private static final int SIDES = 40;

  private static final Mesh BALL = LatheMesh.ball(SIDES);

  /** A frame around a square with edges of length 1, in the plane of x and y. */
  private static final Mesh FRAME =
      new MeshBuilder()
          .box(new Vec3(0.55, 0, 0), new Vec3(0.06, 1.16, 0.06))
          .box(new Vec3(-0.55, 0, 0), new Vec3(0.06, 1.16, 0.06))
          .box(new Vec3(0, 0.55, 0), new Vec3(1.04, 0.06, 0.06))
          .box(new Vec3(0, -0.55, 0), new Vec3(1.04, 0.06, 0.06))
          .build();

  private static final Mesh CIRCLE = MeshBuilder.of(Quad.onFloor(2));

  /** The cache key of a circle that is seen through obstacles. */
  private static final String HIDDEN_CIRCLE = "hidden circle";

  private static final Range RISING = Range.upwards(GoalTextures.LENGTH);

  /** The outer side of a beacon with radius 1 and height 1. */
  private static final Mesh BEACON_OUTSIDE =
      LatheMesh.of(List.of(new Point(1, 0), new Point(1, 1)), SIDES, RISING);

  private static final Mesh BEACON_INSIDE =
      LatheMesh.of(List.of(new Point(1, 1), new Point(1, 0)), SIDES, RISING.reversed());

  /** An arrow from z = -0.5 to z = 0.5. */
  private static final Mesh ARROW_MESH =
      LatheMesh.of(
          List.of(
              new Point(0, -0.5),
              new Point(0.035, -0.5),
              new Point(0.035, 0.14),
              new Point(0.12, 0.14),
              new Point(0, 0.5)),
          20,
          RISING);

  private record ShapeKey(Object form, Rgb color, GoalState state) {}

  private final Map<ShapeKey, Part> parts = new HashMap<>();

  /**
   * The most recently shown goals. When they change, the cached parts of gates are dropped, because
   * the gates may have changed.
   */
  private List<PlacedGoal> shown = List.of();

  /**
   * Returns the markers of goals. If there are several goals at one place, a goal that is still to
   * be reached takes precedence.
   *
   * @param colors returns the colour of a goal
   */
  List<OverlayItem> of(List<PlacedGoal> marks, Function<PlacedGoal, Rgb> colors, Eye eye) {
    if (!marks.equals(shown)) {
      shown = marks;
      parts.keySet().removeIf(look -> look.form instanceof Shape.Gate);
    }
    return foremost(marks).stream()
        .flatMap(mark -> markers(mark, colors.apply(mark), eye).stream())
        .toList();
  }

  private static Collection<PlacedGoal> foremost(List<PlacedGoal> marks) {
    Map<Vec3, PlacedGoal> foremost = new LinkedHashMap<>();
    for (PlacedGoal mark : marks) {
      foremost.merge(
          mark.place().middle(),
          mark,
          (one, other) -> other.state().compareTo(one.state()) < 0 ? other : one);
    }
    return foremost.values();
  }

  private List<OverlayItem> markers(PlacedGoal mark, Rgb color, Eye eye) {
    return mark.place()
        .match(
            new PlaceCases<>(
                ball -> {
                  Part part = part(BALL, mark, color, GoalTextures::ball);
                  Pose pose = new Pose(ball.middle(), Attitude.LEVEL);
                  return List.of(marker(part, pose, even(ball.radius()), eye));
                },
                circle -> circle(circle, mark, color, eye),
                opening ->
                    mark.state() == GoalState.LATER ? List.of() : gate(opening, mark, color, eye),
                square -> {
                  Part part = part(FRAME, mark, color, GoalTextures::plain);
                  return List.of(marker(part, square.pose(), even(square.edge()), eye));
                }));
  }

  private List<OverlayItem> circle(PlacedGoal.Circle circle, PlacedGoal mark, Rgb color, Eye eye) {
    Pose pose = new Pose(circle.middle().plusScaled(Vec3.UP, OFFSET), Attitude.LEVEL);
    Vec3 scale = even(circle.radius()).withZ(1);
    OverlayItem flat = marker(part(CIRCLE, mark, color, GoalTextures::circle), pose, scale, eye);
    if (mark.state() != GoalState.ACTIVE) {
      return List.of(flat);
    }
    Vec3 high = scale.withZ(BEACON * circle.radius());
    return List.of(
        flat,
        throughObstacles(mark, color, pose, scale, eye),
        marker(beacon(BEACON_INSIDE, mark, color), pose, high, eye),
        marker(beacon(BEACON_OUTSIDE, mark, color), pose, high, eye));
  }

  private List<OverlayItem> gate(PlacedGoal.Opening opening, PlacedGoal mark, Rgb color, Eye eye) {
    boolean active = mark.state() == GoalState.ACTIVE;
    Part outline =
        parts.computeIfAbsent(
            new ShapeKey(opening.gate(), color, mark.state()),
            look ->
                GateOutline.of(
                    opening.gate(), GoalTextures.plain(color, active ? GATE_AHEAD : GATE_DONE)));
    OverlayItem frame =
        OverlayItem.at(opening.middle(), new Instance(outline, opening.pose()), eye);
    return opening
        .way()
        .filter(way -> active)
        .map(way -> List.of(frame, arrow(mark, opening, way, color, eye)))
        .orElse(List.of(frame));
  }

  /**
   * Returns a circle that is faintly visible through obstacles, so that people know where the goal
   * is.
   */
  private OverlayItem throughObstacles(PlacedGoal mark, Rgb color, Pose pose, Vec3 scale, Eye eye) {
    Part part =
        parts.computeIfAbsent(
            new ShapeKey(HIDDEN_CIRCLE, color, mark.state()),
            look ->
                new Part(
                    CIRCLE,
                    GoalTextures.circle(color, opacity(mark)).faded(THROUGH_OBSTACLES),
                    Shading.TRANSLUCENT));
    Vec3 camera = eye.pose().position();
    double distance = camera.distanceTo(pose.position());
    double nearer = Math.min(1, Layer.GOALS.distance(distance, eye) / distance);
    Vec3 shown = camera.plusScaled(pose.position().minus(camera), nearer);
    Instance circle = new Instance(part, new Pose(shown, pose.attitude()), scale.times(nearer), 1);
    return OverlayItem.inFront(Layer.GOALS, circle, distance);
  }

  private Part beacon(Mesh mesh, PlacedGoal mark, Rgb color) {
    return part(mesh, mark, color, (each, opacity) -> GoalTextures.beacon(each));
  }

  private OverlayItem arrow(
      PlacedGoal mark, PlacedGoal.Opening opening, Vec3 way, Rgb color, Eye eye) {
    Part part = part(ARROW_MESH, mark, color, GoalTextures::round);
    double heading = StrictMath.atan2(way.y(), way.x());
    Attitude along = Attitude.ofHeading(heading).after(GateOutline.ALONG_X);
    Pose pose = new Pose(opening.middle(), along);
    return marker(part, pose, even(ARROW * opening.gate().width()), eye);
  }

  /** Creates a texture with a given colour and opacity. */
  private interface Paint {
    Texture of(Rgb color, double opacity);
  }

  private Part part(Mesh mesh, PlacedGoal mark, Rgb color, Paint paint) {
    return parts.computeIfAbsent(
        new ShapeKey(mesh, color, mark.state()),
        look -> new Part(mesh, paint.of(color, opacity(mark)), Shading.TRANSLUCENT));
  }

  private static double opacity(PlacedGoal mark) {
    return switch (mark.state()) {
      case ACTIVE -> 0.95;
      case DONE -> 0.7;
      case LATER -> 0.85;
    };
  }

  private static Vec3 even(double factor) {
    return new Vec3(factor, factor, factor);
  }

  private static OverlayItem marker(Part part, Pose pose, Vec3 scale, Eye eye) {
    return OverlayItem.at(pose.position(), new Instance(part, pose, scale, 1), eye);
  }
}
