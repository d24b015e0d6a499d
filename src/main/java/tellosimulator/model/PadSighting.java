package tellosimulator.model;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.time.SimTime;

/**
 * A mission pad that a drone sees. Immutable.
 *
 * @param id 1 to 8
 * @param pad the pose of the pad's frame in the room frame
 * @param moment the time of the sighting, and the drone's pose
 * @param below whether the downward camera sees the pad; if not, only the forward camera sees it
 */
public record PadSighting(int id, Pose pad, Moment moment, boolean below) {

  /**
   * The time of a sighting, and the drone's pose.
   *
   * @param since the time from which the pad has been in sight without interruption
   * @param drone the drone's pose in the room frame at the latest detection
   */
  public record Moment(SimTime since, Pose drone) {}

  /** Returns the vector from the pad to the drone, in the pad's frame [m]. */
  public Vec3 offset() {
    return pad.attitude().toBody(moment.drone().position().minus(pad.position()));
  }

  /** Returns the mission pad fields of the state line for this sighting. */
  public PadReading reading() {
    Attitude turn = pad.attitude().inverse().after(moment.drone().attitude());
    Vec3 attitudeDeg =
        new Vec3(
            StrictMath.toDegrees(turn.elevation()),
            StrictMath.toDegrees(Frames.wrapped(turn.heading())),
            StrictMath.toDegrees(turn.bank()));
    return new PadReading(id, offset().times(100), attitudeDeg);
  }
}
