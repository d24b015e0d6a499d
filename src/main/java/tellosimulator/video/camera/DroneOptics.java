package tellosimulator.video.camera;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;

/**
 * The optics of a drone's cameras, which are fixed to its body. What is not known for sure can be
 * chosen.
 *
 * @param fieldOfView horizontal, of the forward camera [rad]
 * @param tilt how far the forward camera looks down [rad]
 */
public record DroneOptics(double fieldOfView, double tilt) {

  /** Width of a frame in pixels. Measured: 960 by 720 (CAP and others). */
  public static final int WIDTH = 960;

  /** Height of a frame in pixels. */
  public static final int HEIGHT = 720;

  /**
   * Diagonal field of view [degrees]. Documented: Tello User Manual; it does not describe the
   * stream.
   */
  public static final double MANUALS_DIAGONAL_DEG = 82.6;

  /** Narrowest and widest horizontal field of view that can be chosen [degrees]. Decided. */
  public static final int NARROWEST_DEG = 10;

  public static final int WIDEST_DEG = 150;

  /** Steepest tilt up or down that can be chosen [degrees]. */
  public static final int STEEPEST_DEG = 90;

  public static final DroneOptics DEFAULT =
      new DroneOptics(DroneSpec.CAMERA_FIELD_OF_VIEW, DroneSpec.CAMERA_TILT);

  /**
   * Position of the forward camera, body frame [m]. Measured: 3.5 cm ahead of the middle (from the
   * same model); the height is that of the lens.
   */
  private static final Vec3 NOSE = new Vec3(0.035, 0, 0.0185);

  /**
   * Position of the downward camera, body frame [m]. Assumed: in the middle of the underside, 8 mm
   * above the feet.
   */
  private static final Vec3 UNDERSIDE = new Vec3(0, 0, 0.008);

  /** Farthest near plane [m]. Decided: nearer than what a drone can touch with its nose, 2 cm. */
  private static final double MAX_NEAR = 0.02;

  /** The near plane's distance, as a share of the floor's. Decided. */
  private static final double NEAR_MARGIN = 0.9;

  /**
   * Near plane of the downward camera [m]. Decided: nearer than the floor on which the drone
   * stands.
   */
  private static final double NEAR_BELOW = 0.004;

  /**
   * Straight down, with the nose to the left of the image: x down, y ahead, z to the right of the
   * body.
   */
  private static final Attitude DOWN = new Attitude(0.5, 0.5, 0.5, -0.5);

  public DroneOptics {
    if (!(fieldOfView > 0 && fieldOfView < Math.PI)) {
      throw new IllegalArgumentException(
          "fieldOfView is " + fieldOfView + ", but must be between 0 and pi");
    }
    if (!(Math.abs(tilt) <= Math.PI / 2)) {
      throw new IllegalArgumentException(
          "tilt is " + tilt + ", but must be between -pi/2 and pi/2");
    }
  }

  /**
   * Converts a diagonal field of view to a horizontal one.
   *
   * @param diagonal for the aspect ratio of the drone's frames [rad]
   */
  public static double horizontalFieldOfView(double diagonal) {
    double share = WIDTH / StrictMath.hypot(WIDTH, HEIGHT);
    return 2 * StrictMath.atan(share * StrictMath.tan(diagonal / 2));
  }

  /** The pose of the forward camera, room frame; it looks along its x axis. */
  public Pose nose(Pose drone) {
    Attitude down = new Attitude(StrictMath.cos(tilt / 2), 0, StrictMath.sin(tilt / 2), 0);
    return mounted(drone, NOSE, down);
  }

  /**
   * The forward camera. The horizontal field of view is the same for any aspect ratio.
   *
   * @param width of the image in pixels
   * @param height of the image in pixels
   */
  public PinholeCamera ahead(Pose drone, int width, int height) {
    return new PinholeCamera(nose(drone), new CameraIntrinsics(width, height, fieldOfView), near());
  }

  /**
   * Near plane of the forward camera, along its axis [m]: nearer than the floor is at the lower
   * edge of the image while the drone stands, but not so far that it would clip things in front of
   * the drone.
   */
  public double near() {
    double halfHeight = StrictMath.atan(StrictMath.tan(fieldOfView / 2) * HEIGHT / WIDTH);
    double down = tilt + halfHeight;
    double floor =
        down <= 0
            ? MAX_NEAR
            : NOSE.z() * StrictMath.cos(halfHeight) / StrictMath.sin(Math.min(down, Math.PI / 2));
    return Math.min(MAX_NEAR, NEAR_MARGIN * floor);
  }

  /**
   * The downward camera, with the default horizontal field of view. The drone's nose is to the left
   * in the image. Assumed: the field of view. Measured: the direction (DTP #140).
   *
   * @param width of the image in pixels
   * @param height of the image in pixels
   */
  public PinholeCamera below(Pose drone, int width, int height) {
    CameraIntrinsics intrinsics = new CameraIntrinsics(width, height, DEFAULT.fieldOfView);
    return new PinholeCamera(mounted(drone, UNDERSIDE, DOWN), intrinsics, NEAR_BELOW);
  }

  private static Pose mounted(Pose drone, Vec3 offset, Attitude rotation) {
    Attitude attitude = drone.attitude();
    return new Pose(drone.position().plus(attitude.toRoom(offset)), attitude.after(rotation));
  }
}
