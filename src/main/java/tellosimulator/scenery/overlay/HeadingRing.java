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
import tellosimulator.scenery.overlay.OverlayItem.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The ring around a drone that appears small on the screen. The ring shows the drone's position; an
 * arrowhead on the ring, in front of the drone's nose, shows the heading. Seen from above, the ring
 * is level with the drone; seen from the side, it leans towards the camera, so that it never
 * collapses to a line. Nothing in the room hides it. Immutable.
 */
final class HeadingRing {

  /**
   * Height of the drone's middle above its feet [m]. Documented: half of the drone's height of 41
   * mm.
   */
  private static final double MIDDLE = 0.02;

  /**
   * Minimum distance from the camera at which a drone has a ring [m]. Decided: at this distance a
   * drone is 60 pixels wide.
   */
  private static final double NEAREST = 2.5;

  /**
   * Radius of the ring around a lone drone, as a fraction of the distance from the camera. Decided:
   * by eye.
   */
  private static final double RADIUS = 0.034;

  /**
   * Distance from the centre to the tip of the arrowhead, as a multiple of the radius. Decided: by
   * eye.
   */
  private static final double TIP = 1.9;

  /** Minimum elevation of the camera above the plane of the ring [rad]. Decided: by eye. */
  private static final double LEAST_ELEVATION = Math.toRadians(30);

  /**
   * Luma above which a ring has a dark rim. Decided: a light rim would be invisible in front of a
   * light wall.
   */
  private static final double BRIGHT = 0.7;

  private static final Rgb DARK_RIM = Rgb.of(0x24292f);

  /** Side length of the texture [texels]. */
  private static final int TEXELS = 128;

  /** Radius of the ring in the texture [texels]. */
  private static final double RING = (TEXELS / 2.0 - 4) / TIP;

  private static final Point CENTER = new Point(TEXELS / 2.0, TEXELS / 2.0);

  /** A square for a ring of radius 1. */
  private static final Mesh MESH = MeshBuilder.of(Quad.onFloor(TEXELS / RING));

  /** Line width of a normal ring [texels]. Decided: by eye. */
  private static final double LINE = 4.5;

  /** Line width of the ring around a selected drone [texels]. Decided: by eye. */
  private static final double BOLD_LINE = 9;

  /**
   * Scale of the ring around a selected drone. Decided: the ring is easy to find among twenty
   * rings.
   */
  private static final double LARGER = 1.4;

  private final Part part;
  private final Part bold;
  private final double share;

  /**
   * Creates the ring of a drone.
   *
   * @param drones total number of drones
   */
  HeadingRing(Livery livery, int drones) {
    share = RADIUS * Enlargement.crowded(drones);
    part = new Part(MESH, texture(livery.color(), LINE), Shading.TRANSLUCENT);
    bold = new Part(MESH, texture(livery.color(), BOLD_LINE), Shading.TRANSLUCENT);
  }

  /**
   * Returns the ring of a drone, or an empty result if the drone is large enough without it. The
   * ring of a selected drone is in front of all others.
   *
   * @param drone pose of the drone in the room frame
   */
  Optional<OverlayItem> around(Pose drone, Emphasis emphasis, Eye eye) {
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
    return Optional.of(OverlayItem.inFront(Layer.RINGS, ring, order));
  }

  private double share(Emphasis emphasis) {
    return emphasis == Emphasis.STRONG ? LARGER * share : share;
  }

  /**
   * Returns how far the ring extends upwards on the screen, measured from the drone's middle [m].
   *
   * @param drone pose of the drone in the room frame
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

  /**
   * Returns the attitude of the ring. The ring has the same heading as the drone. It is level if
   * the elevation of the camera, as seen from the drone, is at least {@link #LEAST_ELEVATION};
   * otherwise, it leans towards the camera.
   */
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
   * Draws a ring with an arrowhead that points upwards.
   *
   * @param line width of the line [texels]
   * @param wider distance by which all edges are moved outwards [texels]
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
