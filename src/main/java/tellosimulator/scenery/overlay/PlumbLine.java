package tellosimulator.scenery.overlay;

import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/** The line from a drone straight down to the floor. Immutable; for any thread. */
final class PlumbLine {

  /** Below this height there is none [m]. Decided. */
  private static final double LOWEST = 0.03;

  /** Its width, as a share of the distance from the camera. Decided: two or three pixels. */
  private static final double WIDTH = 0.0025;

  /** Decided: by eye. */
  private static final double OPACITY = 0.6;

  /** 1 wide and 1 high, seen from where x leads. */
  private static final Mesh MESH =
      MeshBuilder.of(new Quad(new Vec3(0, -0.5, 0), new Vec3(0, 1, 0), Vec3.UP));

  private final Part part;

  PlumbLine(Livery livery) {
    Texture color = new Texture(1, 1, new int[] {livery.color().argb(OPACITY)});
    part = new Part(MESH, color, Shading.TRANSLUCENT);
  }

  /**
   * A billboard that turns to the camera about the vertical axis; empty while a drone is down.
   *
   * @param drone its position, room frame [m]
   * @param camera its position, room frame [m]
   */
  Optional<Instance> from(Vec3 drone, Vec3 camera) {
    if (drone.z() <= LOWEST) {
      return Optional.empty();
    }
    Vec3 towards = camera.minus(drone);
    double heading = StrictMath.atan2(towards.y(), towards.x());
    Pose foot = new Pose(drone.withZ(0), Attitude.ofHeading(heading));
    return Optional.of(new Instance(part, foot, new Vec3(1, WIDTH * towards.norm(), drone.z()), 1));
  }
}
