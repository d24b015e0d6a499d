package tellosimulator.view.world;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * A point and a heading that follow a drone smoothly. They lag a little behind the drone, so that
 * its starting and braking can be seen, but never so far that the drone leaves the view. Not
 * thread-safe.
 */
final class SmoothFollow {

  /** Time constant of the point [s]. Decided: by eye. */
  static final double TIME_CONSTANT = 0.35;

  /** Time constant of the heading [s]. Decided: by eye. */
  private static final double TURN_TIME_CONSTANT = 0.25;

  private Vec3 point;
  private double heading;

  SmoothFollow(Vec3 point, double heading) {
    this.point = point;
    this.heading = heading;
  }

  /**
   * Advances the time.
   *
   * @param target the position of the drone [m]
   * @param targetHeading the heading of the drone [rad]
   * @param seconds the time since the last call [s]
   * @param farthest the maximum lag [m]
   */
  void advance(Vec3 target, double targetHeading, double seconds, double farthest) {
    double part = 1 - Math.exp(-seconds / TIME_CONSTANT);
    Vec3 behind = target.minus(point).times(1 - part);
    point = behind.norm() < 1e-4 ? target : target.minus(behind.limitedTo(farthest));
    double turn = Frames.wrapped(targetHeading - heading);
    double left = turn * Math.exp(-seconds / TURN_TIME_CONSTANT);
    heading = Math.abs(left) < 1e-4 ? targetHeading : Frames.wrapped(targetHeading - left);
  }

  Vec3 point() {
    return point;
  }

  double heading() {
    return heading;
  }
}
