package tellosimulator.model;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * How a drone moves at a moment.
 *
 * @param position of its feet, room frame [m]
 * @param velocity room frame [m/s]
 * @param acceleration over the last step, without gravity: what an accelerometer feels, room frame
 *     [m/s²]
 * @param attitude body frame to room frame
 * @param rate angular velocity, body frame [rad/s]
 */
public record Motion(
    Vec3 position, Vec3 velocity, Vec3 acceleration, Attitude attitude, Vec3 rate) {

  /** At rest on the floor. */
  public static Motion restingAt(Pose pose) {
    Vec3 support = Vec3.UP.times(DroneSpec.GRAVITY);
    return new Motion(pose.position(), Vec3.ZERO, support, pose.attitude(), Vec3.ZERO);
  }

  public Pose pose() {
    return new Pose(position, attitude);
  }

  /** The same motion, held back by a surface. */
  public Motion heldAt(Vec3 newPosition, Vec3 newVelocity) {
    return new Motion(newPosition, newVelocity, acceleration, attitude, rate);
  }
}
