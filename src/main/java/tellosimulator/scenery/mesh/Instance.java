package tellosimulator.scenery.mesh;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A part with its pose in the room.
 *
 * @param pose pose of the part in the room frame
 * @param scale scale factors of the mesh along its own axes; 1 leaves it unscaled
 * @param opacity 0 to 1; used only with {@link Shading#DECAL}
 */
public record Instance(Part part, Pose pose, Vec3 scale, double opacity) {

  private static final Vec3 UNSCALED = new Vec3(1, 1, 1);

  /** Creates an instance of a part whose mesh is already in the room frame. */
  public static Instance atOrigin(Part part) {
    return new Instance(part, new Pose(Vec3.ZERO, Attitude.LEVEL));
  }

  /** Creates an unscaled instance. */
  public Instance(Part part, Pose pose) {
    this(part, pose, UNSCALED, 1);
  }

  /** Creates an instance that is scaled by the same factor along each axis. */
  public Instance(Part part, Pose pose, double scale, double opacity) {
    this(part, pose, new Vec3(scale, scale, scale), opacity);
  }

  /** Scales a position in the mesh. */
  public Vec3 scaled(Vec3 position) {
    return new Vec3(scale.x() * position.x(), scale.y() * position.y(), scale.z() * position.z());
  }

  /** Returns the largest scale factor of the three axes. */
  public double largestScale() {
    return Math.max(scale.x(), Math.max(scale.y(), scale.z()));
  }
}
