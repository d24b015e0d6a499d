package tellosimulator.math;

/**
 * Every conversion between the core's axes and units and those of the wire and of the screen.
 *
 * <p>The core uses SI, x along the heading (or the room's depth), y to the left, z up, and turns
 * counter-clockwise seen from above. The wire uses centimetres and degrees; its yaw and turns are
 * clockwise, and its velocities and accelerations have y to the right and z down. The screen
 * (JavaFX) has x to the right, y down and z into it; who looks at it looks along the core's x.
 */
public final class Frames {

  private Frames() {}

  public static double meters(double centimeters) {
    return centimeters / 100;
  }

  public static double centimeters(double meters) {
    return meters * 100;
  }

  /** Radians counter-clockwise from degrees clockwise. */
  public static double headingOfYaw(double yawDeg) {
    return -StrictMath.toRadians(yawDeg);
  }

  /** Degrees clockwise from radians counter-clockwise. */
  public static double yawOfHeading(double heading) {
    return -StrictMath.toDegrees(heading);
  }

  /** From x forward, y left, z up to x forward, y right, z down, and back. */
  public static Vec3 flipped(Vec3 vector) {
    return new Vec3(vector.x(), -vector.y(), -vector.z());
  }

  /** From x forward, y left, z up to the screen's x right, y down, z into it. */
  public static Vec3 toScreen(Vec3 vector) {
    return new Vec3(-vector.y(), -vector.z(), vector.x());
  }

  /** From the screen's x right, y down, z into it to x forward, y left, z up. */
  public static Vec3 fromScreen(Vec3 vector) {
    return new Vec3(vector.z(), -vector.x(), -vector.y());
  }

  /** The same angle within ±π [rad]. */
  public static double wrapped(double angle) {
    return StrictMath.IEEEremainder(angle, 2 * Math.PI);
  }
}
