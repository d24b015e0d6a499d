package tellosimulator.view.world;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * A point and a heading that follow a drone smoothly: a little behind, so that one sees it start
 * and brake, but never so far that it leaves the picture. For one thread.
 */
final class SmoothFollow {

  /** How long the point takes for most of the way [s]. Decided: by eye. */
  static final double TIME_CONSTANT = 0.35;

  /** The same for the heading [s]. Decided: by eye. */
  private static final double TURN_TIME_CONSTANT = 0.25;

  private Vec3 point;
  private double heading;

  SmoothFollow(Vec3 point, double heading) {
    this.point = point;
    this.heading = heading;
  }

  /**
   * Lets time pass.
   *
   * @param target where to [m]
   * @param targetHeading radians
   * @param seconds since the last call
   * @param farthest how far behind it may stay [m]
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
