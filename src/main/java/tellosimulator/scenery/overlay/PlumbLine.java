package tellosimulator.scenery.overlay;

import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The dashed line from a drone straight down to the floor, in another colour than its path, and a
 * target of the drone's colour where it meets the floor; or the line alone, from what hangs in the
 * air. Immutable; for any thread.
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

  private static final Texture DASHED = dashes();

  private static final Part LINE = part(MESH, DASHED, Emphasis.NORMAL);
  private static final Part FAINT_LINE = part(MESH, DASHED, Emphasis.FAINT);

  /** Radius of the target, as a share of the distance from the camera. Decided: by eye. */
  private static final double RADIUS = 0.014;

  /** Least radius of the target [m]. Decided: by eye. */
  private static final double LEAST_RADIUS = 0.05;

  /** Above the floor [m]. Decided: it does not flicker from 10 m away, nor over goals' circles. */
  private static final double OFFSET = 0.009;

  private static final int TEXELS_OF_TARGET = 64;

  private static final Point CENTER = new Point(32, 32);

  private static final Mesh TARGET = MeshBuilder.of(Quad.onFloor(2));

  private final Part target;
  private final Part faintTarget;

  PlumbLine(Livery livery) {
    Texture texture =
        new Canvas(TEXELS_OF_TARGET, livery.color())
            .paint(Rgb.WHITE, mask -> mask.stroke(Arc.circle(CENTER, 17).points(), 8))
            .cutOut(new AlphaMask(TEXELS_OF_TARGET).dot(CENTER, 30));
    target = part(TARGET, texture, Emphasis.NORMAL);
    faintTarget = part(TARGET, texture, Emphasis.FAINT);
  }

  private static Part part(Mesh mesh, Texture texture, Emphasis emphasis) {
    return new Part(mesh, texture.faded(emphasis.opacity()), Shading.TRANSLUCENT);
  }

  private static Texture dashes() {
    int[] texels = new int[2 * DASHES * TEXELS];
    for (int i = 0; i < texels.length; i++) {
      texels[i] = COLOR.argb(i / TEXELS % 2 == 0 ? OPACITY : 0);
    }
    return new Texture(1, texels.length, texels);
  }

  /**
   * The line, which turns to the camera about the vertical axis, and the target; empty while a
   * drone is down.
   *
   * @param drone its position, room frame [m]
   * @param camera its position, room frame [m]
   */
  List<Instance> from(Vec3 drone, Vec3 camera, Emphasis emphasis) {
    if (drone.z() <= LOWEST) {
      return List.of();
    }
    double radius = Math.max(LEAST_RADIUS, RADIUS * camera.distanceTo(drone.withZ(0)));
    Pose level = new Pose(drone.withZ(OFFSET), Attitude.LEVEL);
    Part part = emphasis == Emphasis.FAINT ? faintTarget : target;
    return List.of(new Instance(part, level, radius, 1), line(drone, camera, emphasis));
  }

  /**
   * The line alone.
   *
   * @param top where it begins, above the floor, room frame [m]
   * @param camera its position, room frame [m]
   */
  static Instance line(Vec3 top, Vec3 camera, Emphasis emphasis) {
    Vec3 towards = camera.minus(top);
    double heading = StrictMath.atan2(towards.y(), towards.x());
    Pose foot = new Pose(top.withZ(0), Attitude.ofHeading(heading));
    Vec3 size = new Vec3(1, WIDTH * towards.norm(), top.z());
    return new Instance(emphasis == Emphasis.FAINT ? FAINT_LINE : LINE, foot, size, 1);
  }
}
