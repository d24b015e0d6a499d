package tellosimulator.view;

import javafx.scene.transform.Affine;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * The axes of {@link Frames} as transforms of JavaFX. A group with {@link #ofRoom} holds everything
 * in the room frame and in metres; in it, bodies and cameras have their poses.
 */
public final class FxFrames {

  private static final Vec3 X = new Vec3(1, 0, 0);
  private static final Vec3 Y = new Vec3(0, 1, 0);
  private static final Vec3 Z = new Vec3(0, 0, 1);

  private FxFrames() {}

  /** From the room frame to the axes of JavaFX. */
  public static Affine ofRoom() {
    Affine transform = new Affine();
    set(transform, Frames.toScreen(X), Frames.toScreen(Y), Frames.toScreen(Z));
    return transform;
  }

  /** Makes of a transform the one from a body's frame to the room frame. */
  public static void place(Affine transform, Pose pose) {
    Attitude attitude = pose.attitude();
    set(transform, attitude.toRoom(X), attitude.toRoom(Y), attitude.up());
    move(transform, pose.position());
  }

  /** Makes of a transform the one of a camera that looks along its body's x axis, in the room. */
  public static void aim(Affine transform, Pose pose) {
    Attitude attitude = pose.attitude();
    set(
        transform,
        attitude.toRoom(Frames.fromScreen(X)),
        attitude.toRoom(Frames.fromScreen(Y)),
        attitude.toRoom(Frames.fromScreen(Z)));
    move(transform, pose.position());
  }

  private static void set(Affine transform, Vec3 x, Vec3 y, Vec3 z) {
    transform.setToTransform(
        x.x(), y.x(), z.x(), 0, x.y(), y.y(), z.y(), 0, x.z(), y.z(), z.z(), 0);
  }

  private static void move(Affine transform, Vec3 position) {
    transform.setTx(position.x());
    transform.setTy(position.y());
    transform.setTz(position.z());
  }
}
