package tellosimulator.scenery.overlay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Material;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;

/** The dashed line from a drone to the goal that comes next. For one thread. */
final class GoalLine {

  /** A dash and its gap [m]. Decided: by eye. */
  private static final double DASH = 0.14;

  /** Most dashes; a longer line has longer ones. */
  private static final int MOST = 120;

  /** A shorter line is none [m]. Decided: within the drone. */
  private static final double SHORTEST = 0.1;

  /** Half its thickness [m], as a share of the distance from the camera. Decided: two pixels. */
  private static final double HALF_WIDTH = 0.0011;

  private static final int SIDES = 4;

  /** By the number of dashes. */
  private final Map<Integer, Mesh> meshes = new HashMap<>();

  private final Map<Rgb, Material> materials = new HashMap<>();

  /**
   * A line; empty if the ends are too near to each other.
   *
   * @param from room frame [m]
   * @param to room frame [m]
   * @param camera its position, room frame [m]
   */
  Optional<Instance> of(Vec3 from, Vec3 to, Rgb color, Vec3 camera) {
    Vec3 way = to.minus(from);
    double length = way.norm();
    if (length < SHORTEST) {
      return Optional.empty();
    }
    int dashes = (int) Math.max(1, Math.min(MOST, Math.round(length / DASH)));
    Mesh mesh = meshes.computeIfAbsent(dashes, GoalLine::tube);
    Material material =
        materials.computeIfAbsent(
            color, each -> new Material(GoalTextures.dash(each), Shading.TRANSLUCENT));
    double distance = camera.distanceTo(from.plusScaled(way, 0.5));
    double radius = HALF_WIDTH * distance;
    Pose pose = new Pose(from, Attitude.tiltedTo(way.times(1 / length)));
    return Optional.of(
        new Instance(new Part(mesh, material), pose, new Vec3(radius, radius, length), 1));
  }

  /** Radius 1, from the origin to 1 along z. */
  private static Mesh tube(int dashes) {
    List<LatheMesh.Point> outline = List.of(new LatheMesh.Point(1, 0), new LatheMesh.Point(1, 1));
    return LatheMesh.of(outline, SIDES, new LatheMesh.Range(dashes, 0));
  }
}
