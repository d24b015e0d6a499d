package tellosimulator.math;

/**
 * Converts between the axes and units of the core, the wire and the screen.
 *
 * <p>The core uses SI units, with x along the heading (or the room's depth), y to the left and z
 * up; turns are counter-clockwise seen from above. The wire, which is the drone's network protocol,
 * uses centimetres and degrees; its yaw and turns are clockwise, and its velocities and
 * accelerations have y to the right and z down. The screen (JavaFX) has x to the right, y down and
 * z into the screen. The viewer of the screen looks along the core's x axis.
 */
public final class Frames {

  private Frames() {}

  public static double meters(double centimeters) {
    return centimeters / 100;
  }

  public static double centimeters(double meters) {
    return meters * 100;
  }

  /** Converts degrees clockwise to radians counter-clockwise. */
  public static double headingOfYaw(double yawDeg) {
    return -StrictMath.toRadians(yawDeg);
  }

  /** Converts radians counter-clockwise to degrees clockwise. */
  public static double yawOfHeading(double heading) {
    return -StrictMath.toDegrees(heading);
  }

  /**
   * Converts from the axes x forward, y left, z up to the axes x forward, y right, z down. The
   * conversion is its own inverse.
   */
  public static Vec3 flipped(Vec3 vector) {
    return new Vec3(vector.x(), -vector.y(), -vector.z());
  }

  /**
   * Converts from x forward, y left, z up to the screen's axes: x right, y down, z into the screen.
   */
  public static Vec3 toScreen(Vec3 vector) {
    return new Vec3(-vector.y(), -vector.z(), vector.x());
  }

  /**
   * Converts from the screen's axes (x right, y down, z into the screen) to x forward, y left, z
   * up.
   */
  public static Vec3 fromScreen(Vec3 vector) {
    return new Vec3(vector.z(), -vector.x(), -vector.y());
  }

  /** Returns the equivalent angle within ±π [rad]. */
  public static double wrapped(double angle) {
    return StrictMath.IEEEremainder(angle, 2 * Math.PI);
  }
}
