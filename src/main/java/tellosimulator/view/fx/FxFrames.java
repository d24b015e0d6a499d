package tellosimulator.view.fx;

import java.util.stream.IntStream;
import javafx.scene.transform.Affine;
import javafx.scene.transform.MatrixType;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * Creates and sets the JavaFX transforms between the frames of the simulator and the axes of
 * JavaFX; see {@link Frames}. The transforms of bodies and cameras apply inside a group with the
 * transform {@link #ofRoom}, where coordinates are in the room frame [m].
 */
public final class FxFrames {

  private static final Vec3 X = new Vec3(1, 0, 0);
  private static final Vec3 Y = new Vec3(0, 1, 0);
  private static final Vec3 Z = new Vec3(0, 0, 1);

  private FxFrames() {}

  /** Returns the transform from the room frame to the axes of JavaFX. */
  public static Affine ofRoom() {
    return affine(Frames.toScreen(X), Frames.toScreen(Y), Frames.toScreen(Z), Vec3.ZERO);
  }

  /**
   * Sets a transform so that it converts from the frame of a body to the room frame.
   *
   * @param pose the body's pose in the room frame
   */
  public static void place(Affine transform, Pose pose) {
    Attitude attitude = pose.attitude();
    change(
        transform, affine(attitude.toRoom(X), attitude.toRoom(Y), attitude.up(), pose.position()));
  }

  /**
   * Sets a transform so that it converts from the frame of a JavaFX camera to the room frame.
   *
   * @param pose the camera's pose in the room frame; its x axis is the viewing direction
   */
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

  /**
   * Sets the transform only if it differs, because JavaFX redraws the whole scene for each change.
   */
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
