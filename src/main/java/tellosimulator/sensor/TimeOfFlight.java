package tellosimulator.sensor;

import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;

/** The distance sensor in the belly. */
public final class TimeOfFlight {

  /** Reported where there is no echo [mm]. Measured: 6553 cm. */
  public static final int NONE_MM = 65530;

  /** Least distance that it reports [mm]. Measured: 10 cm on the floor. */
  private static final int LEAST_MM = 100;

  /** Greatest distance with an echo [m]. Documented: positioning works up to 10 m. */
  private static final double GREATEST = 10;

  /** Steepest beam that comes back, as the cosine of the tilt. Assumed: 60 degrees. */
  private static final double STEEPEST = 0.5;

  private TimeOfFlight() {}

  /**
   * The distance from the belly to the floor along its own axis [mm].
   *
   * @param error of the sensor [m]
   */
  static int read(Motion motion, double error) {
    Vec3 up = motion.attitude().up();
    double distance = motion.position().z() / up.z();
    if (up.z() < STEEPEST || distance > GREATEST) {
      return NONE_MM;
    }
    return (int) Math.max(LEAST_MM, Math.round((distance + error) * 1000));
  }
}
