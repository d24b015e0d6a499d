package tellosimulator.scenery.overlay;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Enlargement;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.Marker.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The ring around a drone that is small in the picture, with an arrowhead at its nose's side: where
 * the drone is, and where it looks. It lies level with the drone; seen from the side it leans
 * towards the camera, so that it never closes to a line. Nothing in the room hides it. Immutable;
 * for any thread.
 */
final class HeadingRing {

  /** Height of the drone's middle above its feet [m]. Documented: half of 41 mm. */
  private static final double MIDDLE = 0.02;

  /** Nearer than this a drone needs no ring [m]. Decided: it is 60 pixels wide there. */
  private static final double NEAREST = 2.5;

  /**
   * Its radius around a drone alone, as a share of the distance from the camera. Decided: by eye.
   */
  private static final double RADIUS = 0.034;

  /** From the middle to the tip of the arrowhead, in radii. Decided: by eye. */
  private static final double TIP = 1.9;

  /** From how high above it one sees it at least [rad]. Decided: by eye. */
  private static final double LEAST_ELEVATION = Math.toRadians(30);

  /** A brighter ring has a dark rim [luma]. Decided: a light one is lost on a light wall. */
  private static final double BRIGHT = 0.7;

  private static final Rgb DARK_RIM = Rgb.of(0x24292f);

  /** Edge of the texture, and the ring's radius in it [texels]. */
  private static final int TEXELS = 128;

  private static final double RING = (TEXELS / 2.0 - 4) / TIP;

  private static final Point CENTER = new Point(TEXELS / 2.0, TEXELS / 2.0);

  /** Of a ring of radius 1. */
  private static final Mesh MESH = MeshBuilder.of(Quad.onFloor(TEXELS / RING));

  /** Width of its line, and of that around a chosen drone [texels]. Decided: by eye. */
  private static final double LINE = 4.5;

  private static final double BOLD_LINE = 9;

  /** How much larger the ring around a chosen drone is. Decided: to be found among twenty. */
  private static final double LARGER = 1.4;

  private final Part part;
  private final Part bold;
  private final double share;

  /**
   * @param drones how many there are
   */
  HeadingRing(Livery livery, int drones) {
    share = RADIUS * Enlargement.crowded(drones);
    part = new Part(MESH, texture(livery.color(), LINE), Shading.TRANSLUCENT);
    bold = new Part(MESH, texture(livery.color(), BOLD_LINE), Shading.TRANSLUCENT);
  }

  /**
   * The ring of a drone; empty if the drone is large enough without. That of a chosen drone is in
   * front of all others.
   */
  Optional<Marker> around(Pose drone, Emphasis emphasis, Eye eye) {
    Vec3 middle = drone.position().plusScaled(Vec3.UP, MIDDLE);
    Vec3 camera = eye.pose().position();
    double distance = camera.distanceTo(middle);
    if (distance < NEAREST) {
      return Optional.empty();
    }
    boolean chosen = emphasis == Emphasis.STRONG;
    double order = chosen ? 0 : distance;
    double nearer = Layer.RINGS.distance(order, eye) / distance;
    Vec3 shown = camera.plusScaled(middle.minus(camera), nearer);
    Pose pose = new Pose(shown, attitude(drone, eye));
    double radius = share(emphasis) * distance * nearer;
    Instance ring = new Instance(chosen ? bold : part, pose, radius, 1);
    return Optional.of(Marker.inFront(Layer.RINGS, ring, order));
  }

  private double share(Emphasis emphasis) {
    return emphasis == Emphasis.STRONG ? LARGER * share : share;
  }

  /**
   * How far a ring reaches up in the picture, beyond the drone's middle [m].
   *
   * @param drone room frame
   */
  double reach(Pose drone, Emphasis emphasis, Eye eye) {
    double distance = eye.pose().position().distanceTo(drone.position());
    if (distance < NEAREST) {
      return 0;
    }
    Attitude attitude = attitude(drone, eye);
    Vec3 up = eye.pose().attitude().toRoom(Vec3.UP);
    double along = up.dot(attitude.toRoom(new Vec3(1, 0, 0)));
    double across = up.dot(attitude.toRoom(new Vec3(0, 1, 0)));
    return share(emphasis) * distance * Math.max(TIP * along, StrictMath.hypot(along, across));
  }

  /** Turned as the drone, and level if one looks down on it. */
  private static Attitude attitude(Pose drone, Eye eye) {
    Vec3 way = eye.pose().position().minus(drone.position());
    Vec3 level = way.withZ(0);
    double elevation = StrictMath.atan2(way.z(), level.norm());
    Attitude turned = Attitude.ofHeading(drone.attitude().heading());
    if (elevation >= LEAST_ELEVATION) {
      return turned;
    }
    double lean = LEAST_ELEVATION - elevation;
    Vec3 up =
        Vec3.UP.times(StrictMath.cos(lean)).plusScaled(level, StrictMath.sin(lean) / level.norm());
    return Attitude.tiltedTo(up).after(turned);
  }

  private static Texture texture(Rgb color, double line) {
    Rgb rim = color.luma() > BRIGHT ? DARK_RIM : Rgb.WHITE;
    return new Canvas(TEXELS, rim)
        .paint(color, mask -> draw(mask, line, 0))
        .cutOut(draw(new AlphaMask(TEXELS), line, 2.5));
  }

  /**
   * A ring with an arrowhead upwards.
   *
   * @param line width of its line [texels]
   * @param wider by how much all edges are moved outwards [texels]
   */
  private static AlphaMask draw(AlphaMask mask, double line, double wider) {
    double tip = CENTER.y() - TIP * RING;
    double base = CENTER.y() - RING;
    double half = 0.62 * RING;
    List<Point> arrowhead =
        List.of(
            new Point(CENTER.x(), tip),
            new Point(CENTER.x() + half, base),
            new Point(CENTER.x() - half, base));
    List<Point> closed =
        List.of(arrowhead.get(0), arrowhead.get(1), arrowhead.get(2), arrowhead.get(0));
    return mask.stroke(Arc.circle(CENTER, RING).points(), line + 2 * wider)
        .fill(arrowhead)
        .stroke(closed, 2 * wider);
  }
}
