package tellosimulator.physics;

import tellosimulator.math.Vec3;

/** The target of the drone's control loops in the next step. */
public sealed interface Setpoint {

  /** The motors are off and give no thrust. */
  record MotorsOff() implements Setpoint {}

  /**
   * The drone follows a trajectory in the room frame.
   *
   * @param position the target position, in the room frame [m]
   * @param velocity the target velocity, in the room frame [m/s]
   * @param acceleration the target acceleration, in the room frame [m/s²]
   * @param heading the direction of the nose
   */
  record Track(Vec3 position, Vec3 velocity, Vec3 acceleration, Heading heading)
      implements Setpoint {}

  /**
   * The drone turns at a given rate. Its position is not controlled.
   *
   * @param rate the angular rate, in the body frame [rad/s]
   * @param thrustRatio the thrust-to-weight ratio
   */
  record Spin(Vec3 rate, double thrustRatio) implements Setpoint {}

  /**
   * The direction of the nose.
   *
   * @param angle the heading [rad], counter-clockwise seen from above, 0 along x
   * @param rate the yaw rate [rad/s]
   */
  record Heading(double angle, double rate) {}
}
