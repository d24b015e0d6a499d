package tellosimulator.physics;

import tellosimulator.math.Vec3;

/** What the motors shall achieve in the next step. */
public sealed interface Setpoint {

  /** Motors without thrust. */
  record MotorsOff() implements Setpoint {}

  /**
   * Be somewhere, moving somehow; all in the room frame.
   *
   * @param position metres
   * @param velocity metres per second
   * @param acceleration metres per second squared
   * @param heading where the nose shall point
   */
  record Track(Vec3 position, Vec3 velocity, Vec3 acceleration, Heading heading)
      implements Setpoint {}

  /**
   * Turn at a rate, whatever becomes of the position.
   *
   * @param rate body frame [rad/s]
   * @param thrustRatio thrust for each unit of weight
   */
  record Spin(Vec3 rate, double thrustRatio) implements Setpoint {}

  /**
   * Where the nose points.
   *
   * @param angle radians, counter-clockwise seen from above, 0 along x
   * @param rate radians per second
   */
  record Heading(double angle, double rate) {}
}
