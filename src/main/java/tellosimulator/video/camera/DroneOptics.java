package tellosimulator.video.camera;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * The optics of a drone's cameras, which pitch and roll with it. What is not known for sure can be
 * chosen.
 *
 * @param fieldOfView of the camera in the nose, from the left to the right edge [rad]
 * @param tilt how far it looks down [rad]
 */
public record DroneOptics(double fieldOfView, double tilt) {

  /** Width of a picture in pixels. Measured: 960 by 720 (CAP and others). */
  public static final int WIDTH = 960;

  /** Height of a picture in pixels. */
  public static final int HEIGHT = 720;

  /**
   * Field of view from left to right [degrees]. Measured: 55, from calibrated pictures of the
   * stream of several drones.
   */
  public static final double FIELD_OF_VIEW_DEG = 55;

  /**
   * Field of view from corner to corner [degrees]. Documented: Tello User Manual; it does not
   * describe the stream.
   */
  public static final double MANUALS_DIAGONAL_DEG = 82.6;

  /**
   * How far the camera looks down [degrees]. Measured: about 15, the only concrete figure, from a
   * model of the drone for another simulator; other sources assume 0.
   */
  public static final double TILT_DEG = 15;

  public static final DroneOptics DEFAULT =
      new DroneOptics(Math.toRadians(FIELD_OF_VIEW_DEG), Math.toRadians(TILT_DEG));

  /**
   * Where the camera in the nose is, body frame [m]. Measured: 3.5 cm ahead of the middle (from the
   * same model); the height is that of the lens.
   */
  private static final Vec3 NOSE = new Vec3(0.035, 0, 0.0185);

  /**
   * Where the camera that looks down is, body frame [m]. Assumed: in the middle of the underside, 8
   * mm above the feet.
   */
  private static final Vec3 UNDERSIDE = new Vec3(0, 0, 0.008);

  /** Decided: nearer than what a drone can touch with its nose, 2 cm. */
  private static final double FARTHEST_NEAR = 0.02;

  /** What is left to the floor. Decided. */
  private static final double MARGIN = 0.9;

  /**
   * What is nearer to the camera that looks down is not in its picture [m]. Decided: nearer than
   * the floor on which it stands.
   */
  private static final double NEAR_BELOW = 0.004;

  /**
   * Looks straight down, with the nose to the left: x down, y ahead, z to the right of the body.
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
   * The field of view from left to right.
   *
   * @param diagonal from corner to corner of a picture of the drone's shape [rad]
   */
  public static double across(double diagonal) {
    double share = WIDTH / Math.hypot(WIDTH, HEIGHT);
    return 2 * Math.atan(share * Math.tan(diagonal / 2));
  }

  /** The pose of the camera in the nose, room frame; it looks along its x axis. */
  public Pose nose(Pose drone) {
    Attitude down = new Attitude(Math.cos(tilt / 2), 0, Math.sin(tilt / 2), 0);
    return mounted(drone, NOSE, down);
  }

  /**
   * Through the camera in the nose. A picture of another shape shows as much from left to right.
   *
   * @param width of the picture in pixels
   * @param height of the picture in pixels
   */
  public Viewpoint ahead(Pose drone, int width, int height) {
    return new Viewpoint(nose(drone), new Lens(width, height, fieldOfView), near());
  }

  /**
   * What is nearer to the camera in the nose, along its axis, is not in the picture [m]: nearer
   * than the floor is at the lower edge of the picture while the drone stands, but not so far that
   * it would cut things in front of the drone.
   */
  public double near() {
    double halfHeight = Math.atan(Math.tan(fieldOfView / 2) * HEIGHT / WIDTH);
    double down = tilt + halfHeight;
    double floor =
        down <= 0
            ? FARTHEST_NEAR
            : NOSE.z() * Math.cos(halfHeight) / Math.sin(Math.min(down, Math.PI / 2));
    return Math.min(FARTHEST_NEAR, MARGIN * floor);
  }

  /**
   * Through the camera in the underside, which sees as much from left to right as the one in the
   * nose does by default. The drone's nose is to the left in the picture. Assumed: the field of
   * view. Measured: the direction (DTP #140).
   *
   * @param width of the picture in pixels
   * @param height of the picture in pixels
   */
  public Viewpoint below(Pose drone, int width, int height) {
    Lens lens = new Lens(width, height, DEFAULT.fieldOfView);
    return new Viewpoint(mounted(drone, UNDERSIDE, DOWN), lens, NEAR_BELOW);
  }

  private static Pose mounted(Pose drone, Vec3 place, Attitude turn) {
    Attitude attitude = drone.attitude();
    return new Pose(drone.position().plus(attitude.toRoom(place)), attitude.after(turn));
  }
}
