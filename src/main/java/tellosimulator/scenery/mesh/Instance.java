package tellosimulator.scenery.mesh;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A part at its place in the room.
 *
 * @param pose room frame
 * @param scale of the mesh along its own axes; 1 leaves it as it is
 * @param opacity 0 to 1; only for {@link Shading#DECAL}
 */
public record Instance(Part part, Pose pose, Vec3 scale, double opacity) {

  private static final Vec3 UNSCALED = new Vec3(1, 1, 1);

  /** A part whose mesh is in the room frame. */
  public static Instance atOrigin(Part part) {
    return new Instance(part, new Pose(Vec3.ZERO, Attitude.LEVEL));
  }

  /** A part in its own size. */
  public Instance(Part part, Pose pose) {
    this(part, pose, UNSCALED, 1);
  }

  /** A part that is scaled by the same factor along each axis. */
  public Instance(Part part, Pose pose, double scale, double opacity) {
    this(part, pose, new Vec3(scale, scale, scale), opacity);
  }

  /** A position of the mesh, scaled. */
  public Vec3 scaled(Vec3 position) {
    return new Vec3(scale.x() * position.x(), scale.y() * position.y(), scale.z() * position.z());
  }

  /** The largest factor by which the mesh is scaled. */
  public double largestScale() {
    return Math.max(scale.x(), Math.max(scale.y(), scale.z()));
  }
}
