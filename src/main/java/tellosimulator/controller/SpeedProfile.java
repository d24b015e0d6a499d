package tellosimulator.controller;

/**
 * How a way is covered: accelerate, cruise, brake, from rest to rest. Immutable.
 *
 * @param length of the way; metres or radians
 * @param peak greatest speed that is reached
 * @param acceleration positive
 * @param braking positive
 */
record SpeedProfile(double length, double peak, double acceleration, double braking) {

  /** The profile over {@code length} that never exceeds {@code limit}. */
  static SpeedProfile over(double length, double limit, double acceleration, double braking) {
    double reachable = Math.sqrt(2 * length * acceleration * braking / (acceleration + braking));
    return new SpeedProfile(length, Math.min(limit, reachable), acceleration, braking);
  }

  /**
   * Where one is at a time.
   *
   * @param way covered so far
   * @param speed along the way
   * @param acceleration along the way, negative while braking
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
