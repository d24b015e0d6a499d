package tellosimulator.model;

import tellosimulator.math.Vec3;

/**
 * What the state line says of mission pads.
 *
 * @param id 1 to 8, or a negative number that says why there is none
 * @param positionCm the drone's position in the pad's frame [cm]
 * @param attitudeDeg pitch, yaw and roll against the pad [degrees]
 */
public record PadReading(int id, Vec3 positionCm, Vec3 attitudeDeg) {

  /** Detection is off. Report: sample of a state line. */
  public static final PadReading OFF = new PadReading(-2, new Vec3(-200, -200, -200), Vec3.ZERO);

  /** Detection is on, but no pad is seen. Measured: tello-edu-rs, linjunpop/tello. */
  public static final PadReading NONE = new PadReading(-1, new Vec3(-100, -100, -100), Vec3.ZERO);

  /** Whether there is a pad; if not, its attitude means nothing. */
  public boolean seen() {
    return id > 0;
  }
}
