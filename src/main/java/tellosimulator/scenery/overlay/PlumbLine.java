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
 * The dashed line from a drone straight down to the floor. The line and the drone's path have
 * different colours. A target in the drone's colour marks the point at which the line meets the
 * floor. Below an object that is not a drone, there is only the line. Immutable.
 */
final class PlumbLine {

  /** Height up to which a drone counts as being on the ground and has no line [m]. Decided. */
  private static final double LOWEST = 0.03;

  /**
   * Width of the line, as a fraction of the distance from the camera. Decided: two or three pixels.
   */
  private static final double WIDTH = 0.0025;

  private static final Rgb COLOR = Rgb.of(0x4d5761);

  /** Opacity of a dash. Decided: by eye. */
  private static final double OPACITY = 0.75;

  /** Number of dashes between drone and floor. Decided: by eye. */
  private static final int DASHES = 12;

  /** Number of texels in each dash, and in the gap below it. Decided: by eye. */
  private static final int TEXELS = 6;

  /** A square with sides of length 1 that faces along x. */
  private static final Mesh MESH =
      MeshBuilder.of(new Quad(new Vec3(0, -0.5, 0), new Vec3(0, 1, 0), Vec3.UP));

  private static final Texture DASHED = dashes();

  private static final Part LINE = part(MESH, DASHED, Emphasis.NORMAL);
  private static final Part FAINT_LINE = part(MESH, DASHED, Emphasis.FAINT);

  /** Radius of the target, as a fraction of the distance from the camera. Decided: by eye. */
  private static final double RADIUS = 0.014;

  /** Minimum radius of the target [m]. Decided: by eye. */
  private static final double LEAST_RADIUS = 0.05;

  /**
   * Height of the target above the floor [m]. Decided: seen from 10 m away, the target does not
   * flicker, even above the circle of a goal.
   */
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
   * Returns the line and the target, or an empty list while the drone is on the ground. The line is
   * turned about the vertical axis so that it faces the camera.
   *
   * @param drone position of the drone in the room frame [m]
   * @param camera position of the camera in the room frame [m]
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
   * Returns the line without a target.
   *
   * @param top upper end of the line in the room frame, above the floor [m]
   * @param camera position of the camera in the room frame [m]
   */
  static Instance line(Vec3 top, Vec3 camera, Emphasis emphasis) {
    Vec3 towards = camera.minus(top);
    double heading = StrictMath.atan2(towards.y(), towards.x());
    Pose foot = new Pose(top.withZ(0), Attitude.ofHeading(heading));
    Vec3 size = new Vec3(1, WIDTH * towards.norm(), top.z());
    return new Instance(emphasis == Emphasis.FAINT ? FAINT_LINE : LINE, foot, size, 1);
  }
}
