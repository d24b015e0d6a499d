package tellosimulator.model;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.time.SimTime;

/**
 * A mission pad that a drone sees. Immutable; for any thread.
 *
 * @param id 1 to 8
 * @param pad where the pad's frame is, room frame
 * @param moment when it is seen, and from where
 * @param below whether the camera in the underside sees it, and not only that in the nose
 */
public record PadSighting(int id, Pose pad, Moment moment, boolean below) {

  /**
   * When and from where something is seen.
   *
   * @param since from when on, without a break
   * @param drone where the drone was when it looked last, room frame
   */
  public record Moment(SimTime since, Pose drone) {}

  /** From the pad to the drone, in the pad's frame [m]. */
  public Vec3 offset() {
    return pad.attitude().toBody(moment.drone().position().minus(pad.position()));
  }

  /** What the state line says of it. */
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
