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

/** The dashed line from a drone to its next goal. Not thread-safe. */
final class GoalLine {

  /** Total length of a dash and the gap after it [m]. Decided: by eye. */
  private static final double DASH = 0.14;

  /** Maximum number of dashes; if a line would need more, its dashes are longer. */
  private static final int MOST = 120;

  /**
   * Minimum length of a line that is drawn [m]. Decided: a shorter line would be inside the drone.
   */
  private static final double SHORTEST = 0.1;

  /**
   * Half the thickness of the line, as a fraction of the distance from the camera. Decided: the
   * whole line is about two pixels wide.
   */
  private static final double HALF_WIDTH = 0.0011;

  private static final int SIDES = 4;

  /** The tubes by the number of their dashes. */
  private final Map<Integer, Mesh> meshes = new HashMap<>();

  private final Map<Rgb, Material> materials = new HashMap<>();

  /**
   * Returns a line, or an empty result if its ends are too close to each other.
   *
   * @param from start of the line in the room frame [m]
   * @param to end of the line in the room frame [m]
   * @param camera position of the camera in the room frame [m]
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

  /** Returns a tube of radius 1, from z = 0 to z = 1. */
  private static Mesh tube(int dashes) {
    List<LatheMesh.Point> outline = List.of(new LatheMesh.Point(1, 0), new LatheMesh.Point(1, 1));
    return LatheMesh.of(outline, SIDES, new LatheMesh.Range(dashes, 0));
  }
}
