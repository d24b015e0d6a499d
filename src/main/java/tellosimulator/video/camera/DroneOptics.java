package tellosimulator.video.camera;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;

/**
 * The optics of a drone's cameras. The cameras are fixed to the drone's body. Only the values that
 * are uncertain can be configured.
 *
 * @param fieldOfView horizontal field of view of the forward camera [rad]
 * @param tilt angle by which the forward camera faces down [rad]
 * @param photoWidth width of photos [pixels]
 */
public record DroneOptics(double fieldOfView, double tilt, int photoWidth) {

  /** Width of a frame [pixels]. Measured: 960 by 720 (CAP and others). */
  public static final int WIDTH = 960;

  /** Height of a frame [pixels]. */
  public static final int HEIGHT = 720;

  /** Width of a photo [pixels]. Documented: 5 megapixels, Tello User Manual; 2592 by 1936. */
  public static final int PHOTO_WIDTH = 2592;

  /** Height of a photo [pixels]. */
  private static final int PHOTO_HEIGHT = 1936;

  /** Smallest configurable width of photos [pixels]. Decided. */
  public static final int SMALLEST_PHOTO = 64;

  /**
   * Diagonal field of view according to the manual [degrees]. Documented: Tello User Manual. The
   * video stream has a narrower field of view.
   */
  public static final double MANUALS_DIAGONAL_DEG = 82.6;

  /** Narrowest configurable horizontal field of view [degrees]. Decided. */
  public static final int NARROWEST_DEG = 10;

  /** Widest configurable horizontal field of view [degrees]. Decided. */
  public static final int WIDEST_DEG = 150;

  /** Steepest configurable tilt, up or down [degrees]. */
  public static final int STEEPEST_DEG = 90;

  public static final DroneOptics DEFAULT =
      new DroneOptics(DroneSpec.CAMERA_FIELD_OF_VIEW, DroneSpec.CAMERA_TILT, PHOTO_WIDTH);

  /**
   * Position of the downward camera, in the body frame [m]. Assumed: in the middle of the
   * underside, 8 mm above the feet.
   */
  private static final Vec3 UNDERSIDE = new Vec3(0, 0, 0.008);

  /**
   * Maximum distance of the near plane [m]. Decided: 2 cm, which is nearer than any obstacle that
   * the drone's nose touches.
   */
  private static final double MAX_NEAR = 0.02;

  /** Distance of the near plane as a fraction of the distance to the floor. Decided. */
  private static final double NEAR_MARGIN = 0.9;

  /**
   * Distance of the downward camera's near plane [m]. Decided: nearer than the floor on which the
   * drone stands.
   */
  private static final double NEAR_BELOW = 0.004;

  /**
   * Attitude of the downward camera in the body frame. The camera's x axis points down, its y axis
   * ahead, and its z axis to the right, so the drone's nose is to the left in the image.
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
    if (photoWidth < SMALLEST_PHOTO || photoWidth % 2 != 0) {
      throw new IllegalArgumentException(
          "photoWidth is " + photoWidth + ", but must be even and at least " + SMALLEST_PHOTO);
    }
  }

  /**
   * Converts a diagonal field of view to a horizontal one.
   *
   * @param diagonal the diagonal field of view, for the aspect ratio of the drone's frames [rad]
   */
  public static double horizontalFieldOfView(double diagonal) {
    double share = WIDTH / StrictMath.hypot(WIDTH, HEIGHT);
    return 2 * StrictMath.atan(share * StrictMath.tan(diagonal / 2));
  }

  /** Returns the height of photos [pixels], even. */
  public int photoHeight() {
    return photoWidth * PHOTO_HEIGHT / PHOTO_WIDTH / 2 * 2;
  }

  /**
   * Returns the pose of the forward camera, in the room frame. The camera faces along its x axis.
   */
  public Pose nose(Pose drone) {
    Attitude down = new Attitude(StrictMath.cos(tilt / 2), 0, StrictMath.sin(tilt / 2), 0);
    return mounted(drone, DroneSpec.CAMERA_PLACE, down);
  }

  /**
   * Returns the forward camera. The horizontal field of view is the same for any aspect ratio.
   *
   * @param width width of the image [pixels]
   * @param height height of the image [pixels]
   */
  public PinholeCamera ahead(Pose drone, int width, int height) {
    return new PinholeCamera(nose(drone), new CameraIntrinsics(width, height, fieldOfView), near());
  }

  /**
   * The distance of the forward camera's near plane, along the camera's axis [m]. While the drone
   * stands, the plane is nearer than the floor at the lower edge of the image. It is never so far
   * away that it would clip objects in front of the drone.
   */
  public double near() {
    double halfHeight = StrictMath.atan(StrictMath.tan(fieldOfView / 2) * HEIGHT / WIDTH);
    double down = tilt + halfHeight;
    double floor =
        down <= 0
            ? MAX_NEAR
            : DroneSpec.CAMERA_PLACE.z()
                * StrictMath.cos(halfHeight)
                / StrictMath.sin(Math.min(down, Math.PI / 2));
    return Math.min(MAX_NEAR, NEAR_MARGIN * floor);
  }

  /**
   * Returns the downward camera, with the default horizontal field of view. In its image, the
   * drone's nose points to the left. Assumed: the field of view. Measured: the direction (DTP
   * #140).
   *
   * @param width width of the image [pixels]
   * @param height height of the image [pixels]
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
