package tellosimulator.goal;

import tellosimulator.goal.PlacedGoal.Square;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;

/**
 * The view of a drone's forward camera, as far as goals depend on it. Decided: it always has the
 * default optics, so that the options for the video's field of view change no result. Immutable.
 *
 * @param camera the pose of the camera in the room frame; it faces along its x axis
 */
public record FrontView(Pose camera) {

  private static final double TAN_ACROSS = StrictMath.tan(DroneSpec.CAMERA_FIELD_OF_VIEW / 2);
  private static final double TAN_UP = TAN_ACROSS * DroneSpec.CAMERA_HEIGHT_SHARE;

  private static final Attitude TILTED =
      new Attitude(
          StrictMath.cos(DroneSpec.CAMERA_TILT / 2),
          0,
          StrictMath.sin(DroneSpec.CAMERA_TILT / 2),
          0);

  /** Returns the view of a drone at a pose. */
  public static FrontView of(Pose drone) {
    Vec3 lens = drone.attitude().toRoom(DroneSpec.CAMERA_PLACE);
    return new FrontView(new Pose(drone.position().plus(lens), drone.attitude().after(TILTED)));
  }

  /**
   * Returns the distance from which a square that faces the camera takes a share of the picture's
   * width [m].
   *
   * @param edge the length of its edge [m]
   */
  public static double distance(double edge, double percent) {
    return 100 * edge / (2 * TAN_ACROSS * percent);
  }

  /**
   * Returns the share of the picture's width that a square takes [percent]; 0 unless all of it is
   * in the picture.
   */
  public double percent(Square square) {
    double right = Double.POSITIVE_INFINITY;
    double left = Double.NEGATIVE_INFINITY;
    for (Vec3 corner : square.corners()) {
      Vec3 seen = camera.attitude().toBody(corner.minus(camera.position()));
      double across = seen.y() / seen.x();
      if (seen.x() <= 0
          || Math.abs(across) > TAN_ACROSS
          || Math.abs(seen.z()) > TAN_UP * seen.x()) {
        return 0;
      }
      right = Math.min(right, across);
      left = Math.max(left, across);
    }
    return 100 * (left - right) / (2 * TAN_ACROSS);
  }
}
