package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
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
import tellosimulator.scenery.overlay.Marker.Layer;
import tellosimulator.world.Shape;

/**
 * The markers of goals in the room: balls to reach, circles to land on, and the gates that come
 * next in the color of goals, with an arrow where one shall fly. Gates that are done are green, so
 * opaque that their own color is not mixed with it. Gates for later have only their tags. Keeps the
 * parts that it has made. For one thread.
 */
final class GoalMarkers {

  /** Above what a circle lies on [m]. Decided: it does not flicker from 10 m away. */
  private static final double OFFSET = 0.006;

  /** Height of the light around the circle that comes next, in its radii. Decided: by eye. */
  private static final double BEACON = 0.7;

  /** Length of an arrow, in widths of the opening. Decided: by eye. */
  private static final double ARROW = 0.8;

  /** How much one sees of a circle through what is in front of it, 0 to 1. Decided: by eye. */
  private static final double THROUGH_OBSTACLES = 0.4;

  /** How opaque the color of a gate that comes next is, 0 to 1. Decided: its segments are seen. */
  private static final double GATE_AHEAD = 0.62;

  /** The same of a gate that is done. Decided: green, whatever its own color is. */
  private static final double GATE_DONE = 0.85;

  private static final int SIDES = 40;

  private static final Mesh BALL = LatheMesh.ball(SIDES);
  private static final Mesh CIRCLE = MeshBuilder.of(Quad.onFloor(2));

  /** The form of a circle that is seen through obstacles. */
  private static final String HIDDEN_CIRCLE = "hidden circle";

  private static final Range RISING = Range.upwards(GoalTextures.LENGTH);

  /** Radius and height 1. */
  private static final Mesh BEACON_OUTSIDE =
      LatheMesh.of(List.of(new Point(1, 0), new Point(1, 1)), SIDES, RISING);

  private static final Mesh BEACON_INSIDE =
      LatheMesh.of(List.of(new Point(1, 1), new Point(1, 0)), SIDES, RISING.reversed());

  /** From -0.5 to 0.5 along z. */
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

  private record Look(Object form, Rgb color, GoalState state) {}

  private final Map<Look, Part> parts = new HashMap<>();

  /** What the last marks had, so that a gate that somebody changes leaves nothing behind. */
  private List<GoalMark> shown = List.of();

  /**
   * The markers of marks. Where several are at one place, the one that is still to be reached
   * counts.
   *
   * @param colors that of a mark
   */
  List<Marker> of(List<GoalMark> marks, Function<GoalMark, Rgb> colors, Eye eye) {
    if (!marks.equals(shown)) {
      shown = marks;
      parts.keySet().removeIf(look -> look.form instanceof Shape.Gate);
    }
    List<Marker> markers = new ArrayList<>();
    for (GoalMark mark : foremost(marks)) {
      add(markers, mark, colors.apply(mark), eye);
    }
    return markers;
  }

  private static Collection<GoalMark> foremost(List<GoalMark> marks) {
    Map<Vec3, GoalMark> foremost = new LinkedHashMap<>();
    for (GoalMark mark : marks) {
      foremost.merge(
          mark.place().middle(), mark, (one, other) -> rank(other) < rank(one) ? other : one);
    }
    return foremost.values();
  }

  private static int rank(GoalMark mark) {
    return switch (mark.state()) {
      case ACTIVE -> 0;
      case LATER -> 1;
      case DONE -> 2;
    };
  }

  private void add(List<Marker> markers, GoalMark mark, Rgb color, Eye eye) {
    GoalMark.Place place = mark.place();
    boolean active = mark.state() == GoalState.ACTIVE;
    if (place instanceof GoalMark.Ball ball) {
      Part part = part(BALL, mark, color, GoalTextures::ball);
      markers.add(marker(part, new Pose(ball.middle(), Attitude.LEVEL), even(ball.radius()), eye));
    } else if (place instanceof GoalMark.Circle circle) {
      Pose pose = new Pose(circle.middle().plusScaled(Vec3.UP, OFFSET), Attitude.LEVEL);
      Vec3 scale = even(circle.radius()).withZ(1);
      markers.add(marker(part(CIRCLE, mark, color, GoalTextures::circle), pose, scale, eye));
      if (active) {
        markers.add(throughObstacles(mark, color, pose, scale, eye));
        Vec3 high = scale.withZ(BEACON * circle.radius());
        markers.add(marker(beacon(BEACON_INSIDE, mark, color), pose, high, eye));
        markers.add(marker(beacon(BEACON_OUTSIDE, mark, color), pose, high, eye));
      }
    } else if (place instanceof GoalMark.Opening opening && mark.state() != GoalState.LATER) {
      Part outline =
          parts.computeIfAbsent(
              new Look(opening.gate(), color, mark.state()),
              look -> outline(opening.gate(), color, active));
      markers.add(
          new Marker(
              new Instance(outline, opening.pose()),
              eye.pose().position().distanceTo(place.middle())));
      if (active) {
        opening.way().ifPresent(way -> markers.add(arrow(mark, opening, way, color, eye)));
      }
    }
  }

  /** A circle as it is seen through a wall, faintly, so that one knows where it is. */
  private Marker throughObstacles(GoalMark mark, Rgb color, Pose pose, Vec3 scale, Eye eye) {
    Part part =
        parts.computeIfAbsent(
            new Look(HIDDEN_CIRCLE, color, mark.state()),
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
    return Marker.inFront(Layer.GOALS, circle, distance);
  }

  private static Part outline(Shape.Gate gate, Rgb color, boolean active) {
    return GateOutline.of(gate, GoalTextures.plain(color, active ? GATE_AHEAD : GATE_DONE));
  }

  private Part beacon(Mesh mesh, GoalMark mark, Rgb color) {
    return part(mesh, mark, color, (each, opacity) -> GoalTextures.beacon(each));
  }

  private Marker arrow(GoalMark mark, GoalMark.Opening opening, Vec3 way, Rgb color, Eye eye) {
    Part part = part(ARROW_MESH, mark, color, GoalTextures::round);
    double heading = StrictMath.atan2(way.y(), way.x());
    Attitude along = Attitude.ofHeading(heading).after(GateOutline.ALONG_X);
    Pose pose = new Pose(opening.middle(), along);
    return marker(part, pose, even(ARROW * width(opening.gate())), eye);
  }

  private static double width(Shape.Gate gate) {
    return gate instanceof Shape.Ring ring ? 2 * ring.radius() : ((Shape.Frame) gate).width();
  }

  /** Makes a texture of a colour and an opacity. */
  private interface Paint {
    Texture of(Rgb color, double opacity);
  }

  private Part part(Mesh mesh, GoalMark mark, Rgb color, Paint paint) {
    return parts.computeIfAbsent(
        new Look(mesh, color, mark.state()),
        look -> new Part(mesh, paint.of(color, opacity(mark)), Shading.TRANSLUCENT));
  }

  private static double opacity(GoalMark mark) {
    return switch (mark.state()) {
      case ACTIVE -> 0.95;
      case DONE -> 0.7;
      case LATER -> 0.85;
    };
  }

  private static Vec3 even(double factor) {
    return new Vec3(factor, factor, factor);
  }

  private static Marker marker(Part part, Pose pose, Vec3 scale, Eye eye) {
    return Marker.at(pose.position(), new Instance(part, pose, scale, 1), eye);
  }
}
