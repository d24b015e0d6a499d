package tellosimulator.model;

import tellosimulator.math.Vec3;

/**
 * The mission pad fields of the state line.
 *
 * @param id 1 to 8, or a negative number that indicates why no pad is reported
 * @param positionCm the drone's position in the pad's frame [cm]
 * @param attitudeDeg pitch, yaw and roll relative to the pad [degrees]
 */
public record PadReading(int id, Vec3 positionCm, Vec3 attitudeDeg) {

  /** The fields while detection is off. Report: sample of a state line. */
  public static final PadReading OFF = new PadReading(-2, new Vec3(-200, -200, -200), Vec3.ZERO);

  /**
   * The fields while detection is on, but no pad is in sight. Measured: tello-edu-rs,
   * linjunpop/tello.
   */
  public static final PadReading NONE = new PadReading(-1, new Vec3(-100, -100, -100), Vec3.ZERO);

  /** Whether a pad is in sight. If not, the attitude is meaningless. */
  public boolean seen() {
    return id > 0;
  }
}
