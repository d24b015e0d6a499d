package tellosimulator.model;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * The motion of a drone at one moment.
 *
 * @param position the position of the feet in the room frame [m]
 * @param velocity the velocity in the room frame [m/s]
 * @param acceleration the proper acceleration (as an accelerometer measures it) over the last step,
 *     in the room frame [m/s²]; at rest, it is +g along z
 * @param attitude the attitude, from the body frame to the room frame
 * @param rate the angular velocity in the body frame [rad/s]
 */
public record Motion(
    Vec3 position, Vec3 velocity, Vec3 acceleration, Attitude attitude, Vec3 rate) {

  /** Returns the motion of a drone at rest. */
  public static Motion restingAt(Pose pose) {
    Vec3 support = Vec3.UP.times(DroneSpec.GRAVITY);
    return new Motion(pose.position(), Vec3.ZERO, support, pose.attitude(), Vec3.ZERO);
  }

  public Pose pose() {
    return new Pose(position, attitude);
  }

  /** Returns a copy for a drone that a surface has stopped. */
  public Motion heldAt(Vec3 newPosition, Vec3 newVelocity) {
    return new Motion(newPosition, newVelocity, acceleration, attitude, rate);
  }
}
