package tellosimulator.profile;

import java.util.Locale;

/**
 * Which account of the real drone is followed where accounts differ: one method a point, the value
 * for {@link #REPORT} first.
 *
 * <p>"Report" is the FHNW report of 2020 on a real Tello EDU; "measured" are published measurements
 * of real drones that go beyond it. {@code docs/protocol.md} names the sources.
 */
public enum Behaviour {
  REPORT,
  MEASURED;

  private <T> T pick(T report, T measured) {
    return this == REPORT ? report : measured;
  }

  /** Height above the floor that a takeoff reaches [m]. */
  public double takeoffHeight() {
    return pick(0.30, 0.80);
  }

  /** Speed of the climb at takeoff [m/s]. Measured: 0.8 peak; Assumed for the report's 30 cm. */
  public double takeoffSpeed() {
    return pick(0.35, 0.80);
  }

  /** What the hover creeps up after a takeoff [m]. Measured: 80 cm at 2.2 s, 94 cm at 4.3 s. */
  public double takeoffCreep() {
    return pick(0.0, 0.08);
  }

  /** From {@code takeoff} to {@code ok} at least [s]. Target times: 3.0 and 5.5 s. */
  public double takeoffTime() {
    return pick(3.0, 5.5);
  }

  /** Standard deviation of where a move ends [m]. Measured: ±5 cm. */
  public double positionSigma() {
    return pick(0.0, 0.025);
  }

  /** Standard deviation of where a turn ends [rad]. Measured: 89 to 90 of 90 degrees. */
  public double headingSigma() {
    return pick(0.0, StrictMath.toRadians(1));
  }

  /** Whether sensors are noisy, {@code h} is offset, yaw drifts and the state line jitters. */
  public boolean noisySensors() {
    return pick(false, true);
  }

  /** Level {@code rc} values up to this one do nothing. Report: 20 does not move the drone. */
  public double rcDeadZone() {
    return pick(20.0, 0.0);
  }

  /** Level speed for each unit of {@code rc} [m/s]. */
  public double rcLevelGain() {
    return pick(0.010, 0.015);
  }

  /** From a level {@code rc} to the first motion [s]. */
  public double rcLevelDelay() {
    return pick(0.35, 0.50);
  }

  /** Time constant of the level response to {@code rc} [s]. */
  public double rcLevelTimeConstant() {
    return 0.6;
  }

  /** Vertical speed for each unit of {@code rc} [m/s]. */
  public double rcVerticalGain() {
    return 0.010;
  }

  /**
   * Turning rate for a yaw value of {@code rc} [rad/s], of the same sign. Report: a degree per
   * second for each unit. Measured: a progressive curve through published points.
   */
  public double rcYawRate(double value) {
    return StrictMath.toRadians(pick(value, YawCurve.degreesPerSecond(value)));
  }

  /** The lowest height at which it hovers [m]. Measured: 27 to 28 cm. */
  public double lowestHover() {
    return pick(0.10, 0.28);
  }

  /**
   * Whether a move that is stopped by {@link #lowestHover} counts as arrived: if not, {@code down}
   * is never answered, and a flight by a pad ends with {@code error Run timeout}.
   */
  public boolean answersLowDown() {
    return pick(true, false);
  }

  /**
   * How far the sensor of the extension board looks ahead [m]. SDK 3.0 guide: 8192 mm stands for
   * nothing within range, so report: up to that. Measured: 2 m at the most, the range of the
   * VL53L0X that the board has (its firmware, RMTT_TOF; data sheet of ST).
   */
  public double boardRange() {
    return pick(8.191, 2.0);
  }

  /** Whether {@code land} is carried out while another command runs, rather than refused. */
  public boolean landsWhileBusy() {
    return pick(false, true);
  }

  /** Whether reads and {@code command} are answered while another command runs. */
  public boolean readsWhileBusy() {
    return pick(false, true);
  }

  /** Shortest time to an immediate reply [s]. Measured: 28 to 90 ms, of which the link is part. */
  public double shortestReplyDelay() {
    return pick(0.0, 0.030);
  }

  /** Longest time to an immediate reply [s]. */
  public double longestReplyDelay() {
    return pick(0.0, 0.050);
  }

  /** Whether {@code ap} and {@code wifi} restart the drone as they do a real one. */
  public boolean restartsForNetwork() {
    return pick(false, true);
  }

  /** How long a full battery flies while it films [s]. */
  public double filmingEndurance() {
    return pick(13.0, 7.5) * 60;
  }

  /** The word that chooses it on the command line. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }
}
