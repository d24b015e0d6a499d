package tellosimulator.profile;

/**
 * The progressive answer of a real drone to the yaw value of {@code rc}.
 *
 * <p>Measured: pgminin/tello-vision-telemetry-lab, three flights; full stick from a calibrated ROS
 * controller (1.55 rad/s). Straight lines between the points.
 */
final class YawCurve {

  private static final double[] VALUES = {0, 3, 5, 10, 20, 40, 45, 100};
  private static final double[] RATES = {0, 0, 1, 4.5, 11, 25, 30, 89};

  private YawCurve() {}

  static double degreesPerSecond(double value) {
    double size = Math.abs(value);
    for (int i = 1; i < VALUES.length; i++) {
      if (size <= VALUES[i]) {
        double part = (size - VALUES[i - 1]) / (VALUES[i] - VALUES[i - 1]);
        return Math.copySign(RATES[i - 1] + part * (RATES[i] - RATES[i - 1]), value);
      }
    }
    return Math.copySign(RATES[RATES.length - 1], value);
  }
}
