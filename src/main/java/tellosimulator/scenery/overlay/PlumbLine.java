package tellosimulator.scenery.overlay;

import java.util.Optional;
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

/**
 * The dashed line from a drone straight down to the floor, in another colour than its path.
 * Immutable; for any thread.
 */
final class PlumbLine {

  /** Below this height there is none [m]. Decided. */
  private static final double LOWEST = 0.03;

  /** Its width, as a share of the distance from the camera. Decided: two or three pixels. */
  private static final double WIDTH = 0.0025;

  private static final Rgb COLOR = Rgb.of(0x4d5761);

  /** Decided: by eye. */
  private static final double OPACITY = 0.75;

  /**
   * Dashes between drone and floor, and texels of each and of the gap below it. Decided: by eye.
   */
  private static final int DASHES = 12;

  private static final int TEXELS = 6;

  /** 1 wide and 1 high, seen from where x leads. */
  private static final Mesh MESH =
      MeshBuilder.of(new Quad(new Vec3(0, -0.5, 0), new Vec3(0, 1, 0), Vec3.UP));

  private static final Part PART = new Part(MESH, dashes(), Shading.TRANSLUCENT);

  private PlumbLine() {}

  private static Texture dashes() {
    int[] texels = new int[2 * DASHES * TEXELS];
    for (int i = 0; i < texels.length; i++) {
      texels[i] = COLOR.argb(i / TEXELS % 2 == 0 ? OPACITY : 0);
    }
    return new Texture(1, texels.length, texels);
  }

  /**
   * A billboard that turns to the camera about the vertical axis; empty while a drone is down.
   *
   * @param drone its position, room frame [m]
   * @param camera its position, room frame [m]
   */
  static Optional<Instance> from(Vec3 drone, Vec3 camera) {
    if (drone.z() <= LOWEST) {
      return Optional.empty();
    }
    Vec3 towards = camera.minus(drone);
    double heading = StrictMath.atan2(towards.y(), towards.x());
    Pose foot = new Pose(drone.withZ(0), Attitude.ofHeading(heading));
    return Optional.of(new Instance(PART, foot, new Vec3(1, WIDTH * towards.norm(), drone.z()), 1));
  }
}
