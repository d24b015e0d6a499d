package tellosimulator.view.fx;

import java.util.stream.IntStream;
import javafx.scene.transform.Affine;
import javafx.scene.transform.MatrixType;
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
    return affine(Frames.toScreen(X), Frames.toScreen(Y), Frames.toScreen(Z), Vec3.ZERO);
  }

  /** Makes of a transform the one from a body's frame to the room frame. */
  public static void place(Affine transform, Pose pose) {
    Attitude attitude = pose.attitude();
    change(
        transform, affine(attitude.toRoom(X), attitude.toRoom(Y), attitude.up(), pose.position()));
  }

  /** Makes of a transform the one of a camera that looks along its body's x axis, in the room. */
  public static void aim(Affine transform, Pose pose) {
    Attitude attitude = pose.attitude();
    change(
        transform,
        affine(
            attitude.toRoom(Frames.fromScreen(X)),
            attitude.toRoom(Frames.fromScreen(Y)),
            attitude.toRoom(Frames.fromScreen(Z)),
            pose.position()));
  }

  /** Only if it is another one: the toolkit draws a whole scene anew for each that is set. */
  private static void change(Affine transform, Affine wanted) {
    double[] before = transform.toArray(MatrixType.MT_3D_3x4);
    double[] now = wanted.toArray(MatrixType.MT_3D_3x4);
    if (IntStream.range(0, now.length).anyMatch(i -> before[i] != now[i])) {
      transform.setToTransform(wanted);
    }
  }

  private static Affine affine(Vec3 x, Vec3 y, Vec3 z, Vec3 at) {
    return new Affine(
        x.x(), y.x(), z.x(), at.x(), x.y(), y.y(), z.y(), at.y(), x.z(), y.z(), z.z(), at.z());
  }
}
