package tellosimulator.controller;

/**
 * A trapezoidal speed profile: accelerate, cruise, brake, from rest to rest. Immutable.
 *
 * @param length the length of the path [m or rad]
 * @param peak the highest speed that is reached [m/s or rad/s]
 * @param acceleration the acceleration at the beginning, positive [m/s² or rad/s²]
 * @param braking the deceleration at the end, positive [m/s² or rad/s²]
 */
record SpeedProfile(double length, double peak, double acceleration, double braking) {

  /** Returns the profile for a path of a given length. Its speed never exceeds {@code limit}. */
  static SpeedProfile over(double length, double limit, double acceleration, double braking) {
    double reachable = Math.sqrt(2 * length * acceleration * braking / (acceleration + braking));
    return new SpeedProfile(length, Math.min(limit, reachable), acceleration, braking);
  }

  /**
   * The state of a profile at one moment.
   *
   * @param way the distance covered so far
   * @param speed the speed along the path
   * @param acceleration the acceleration along the path, negative while braking
   */
  record Sample(double way, double speed, double acceleration) {}

  double duration() {
    return length == 0 ? 0 : peak / acceleration + cruiseTime() + peak / braking;
  }

  Sample at(double seconds) {
    if (seconds <= 0) {
      return new Sample(0, 0, 0);
    }
    double left = duration() - seconds;
    if (left <= 0) {
      return new Sample(length, 0, 0);
    }
    if (seconds < peak / acceleration) {
      double way = acceleration * seconds * seconds / 2;
      return new Sample(way, acceleration * seconds, acceleration);
    }
    if (left < peak / braking) {
      return new Sample(length - braking * left * left / 2, braking * left, -braking);
    }
    double way = peak * seconds - peak * peak / (2 * acceleration);
    return new Sample(way, peak, 0);
  }

  private double cruiseTime() {
    double ramps = peak * peak / 2 * (1 / acceleration + 1 / braking);
    return (length - ramps) / peak;
  }
}
