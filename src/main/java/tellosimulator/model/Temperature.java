package tellosimulator.model;

/**
 * The drone's temperature: it warms up while it idles and is cooled by its propellers.
 *
 * <p>Measured (XG590, PGM): 43 °C cold, 80 to 90 °C after minutes of idling, falling by about 11 K
 * in 20 s after takeoff, then steady at 62 to 77 °C.
 */
final class Temperature {

  /** At power-on [°C]. */
  static final double COLD = 43;

  private static final double IDLE_LIMIT = 88;
  private static final double IDLE_TIME_CONSTANT = 120;
  private static final double FLYING_LIMIT = 68;
  private static final double FLYING_TIME_CONSTANT = 36;

  private Temperature() {}

  static double after(double celsius, boolean motorsOn, double seconds) {
    double limit = motorsOn ? FLYING_LIMIT : IDLE_LIMIT;
    double timeConstant = motorsOn ? FLYING_TIME_CONSTANT : IDLE_TIME_CONSTANT;
    return celsius + (limit - celsius) * seconds / timeConstant;
  }
}
