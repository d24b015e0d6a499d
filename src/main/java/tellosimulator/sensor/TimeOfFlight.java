package tellosimulator.sensor;

import tellosimulator.math.Attitude;

/** The downward distance sensor. */
public final class TimeOfFlight {

  /** Reading without an echo [mm]. Measured: the drone reports 6553 cm. */
  public static final int NONE_MM = 65530;

  /** Minimum reading [mm]. Measured: the drone reports 10 cm on the floor. */
  private static final int LEAST_MM = 100;

  /** Maximum distance with an echo [m]. Documented: positioning works up to 10 m. */
  private static final double GREATEST = 10;

  /** The cosine of the maximum tilt of the drone at which there is an echo. Assumed: 60 degrees. */
  private static final double STEEPEST = 0.5;

  private TimeOfFlight() {}

  /**
   * Returns the reading of the sensor [mm].
   *
   * @param attitude the attitude of the drone
   * @param distance the distance from the underside to the object below, along the drone's vertical
   *     axis [m]
   * @param error the error of the sensor [m]
   */
  static int read(Attitude attitude, double distance, double error) {
    if (attitude.up().z() < STEEPEST || distance > GREATEST) {
      return NONE_MM;
    }
    return (int) Math.max(LEAST_MM, Math.round((distance + error) * 1000));
  }
}
