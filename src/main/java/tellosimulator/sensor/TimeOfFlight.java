package tellosimulator.sensor;

import tellosimulator.math.Attitude;

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
   * What it reports [mm].
   *
   * @param attitude of the drone
   * @param distance from the belly to what is below, along its own axis [m]
   * @param error of the sensor [m]
   */
  static int read(Attitude attitude, double distance, double error) {
    if (attitude.up().z() < STEEPEST || distance > GREATEST) {
      return NONE_MM;
    }
    return (int) Math.max(LEAST_MM, Math.round((distance + error) * 1000));
  }
}
