package tellosimulator.model;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A mission pad that a drone sees. Immutable; for any thread.
 *
 * @param id 1 to 8
 * @param pad where the pad's frame is, room frame
 * @param drone where the drone was when it saw it, room frame
 * @param below whether the camera in the underside sees it, and not that in the nose
 */
public record PadSighting(int id, Pose pad, Pose drone, boolean below) {

  /** From the pad to the drone, in the pad's frame [m]. */
  public Vec3 offset() {
    return pad.attitude().toBody(drone.position().minus(pad.position()));
  }

  /** What the state line says of it. */
  public PadReading reading() {
    Attitude turn = pad.attitude().inverse().after(drone.attitude());
    Vec3 attitudeDeg =
        new Vec3(
            StrictMath.toDegrees(turn.elevation()),
            StrictMath.toDegrees(Frames.wrapped(turn.heading())),
            StrictMath.toDegrees(turn.bank()));
    return new PadReading(id, offset().times(100), attitudeDeg);
  }
}
