package tellosimulator.junit;

import java.util.Locale;
import tellosimulator.world.Wind;

/** Ranges of what a test sets: those of scenario files. */
final class Limits {

  private static final double TURN = 360;

  private Limits() {}

  /**
   * @param speed of the wind [cm/s]
   * @throws IllegalArgumentException with a sentence, if it is out of its range
   */
  static void checkWindSpeed(double speed) {
    check("speed", speed, 0, Wind.FASTEST * 100, "cm/s");
  }

  /**
   * @param name of the angle
   * @param angle [degrees]
   * @throws IllegalArgumentException with a sentence, if it is out of its range
   */
  static void checkAngle(String name, double angle) {
    check(name, angle, -TURN, TURN, "degrees");
  }

  private static void check(String name, double value, double least, double most, String unit) {
    if (!(value >= least && value <= most)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s is %s %s, but must be from %.0f to %.0f",
              name,
              value,
              unit,
              least,
              most));
    }
  }
}
