package tellosimulator.profile;

import java.util.Locale;

/**
 * Which account of the real drone is followed where accounts differ: one method a point, the value
 * for {@link #REPORT} first.
 *
 * <p>"Report" is the FHNW report of 2020 on a real Tello EDU; "measured" are published measurements
 * of real drones that go beyond it. {@code docs/protocol.md} names the sources.
 */
public enum Behavior {
  REPORT,
  MEASURED;

  /**
   * Values of {@code rc} and rates of yaw [degrees/s], with straight lines between them. Measured:
   * pgminin/tello-vision-telemetry-lab, three flights; full stick from a calibrated ROS controller
   * (1.55 rad/s).
   */
  private static final double[] YAW_VALUES = {0, 3, 5, 10, 20, 40, 45, 100};

  private static final double[] YAW_RATES = {0, 0, 1, 4.5, 11, 25, 30, 89};

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

  /**
   * From {@code land} to the first motion down [s]. Measured: 0.75 (xg590/Tello-Python). Assumed
   * for the report: 3.0 s in all from 80 cm.
   */
  public double landingDelay() {
    return pick(0.45, 0.75);
  }

  /**
   * From stopped motors after a landing to {@code ok} [s]. Measured: 1.1 to 1.4 s after touchdown
   * once, hardly any on another drone; 0.75 keeps to 3.0 s from 80 cm, give or take a quarter.
   */
  public double landingSettle() {
    return pick(0.1, 0.75);
  }

  /**
   * How long a drone must be on its target, and still, before {@code ok} [s]. Report: it balances
   * out first. Measured: {@code ok} comes as the speed reaches 0 (xg590/Tello-Python, four moves).
   */
  public double steadyTime() {
    return pick(0.3, 0.0);
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

  /**
   * From a level {@code rc} until the drone begins to lean [s]. Measured: TelloPy 0.7.0,
   * docs/sensor_time.md: a tenth of the angle after 165 ms, half of it after 249 to 266 ms.
   */
  public double rcLevelDelay() {
    return pick(0.35, 0.10);
  }

  /**
   * Time constant with which a level {@code rc} begins to accelerate the drone [s]; 0 for at once.
   * Measured: as for the delay, of which it is the part that is no dead time.
   */
  public double rcLevelOnset() {
    return pick(0.0, 0.06);
  }

  /** Time constant of the level response to {@code rc} [s]. */
  public double rcLevelTimeConstant() {
    return 0.6;
  }

  /**
   * From a turning {@code rc} until the drone begins to turn [s]. Measured: as above: a tenth of
   * the rate after 64 to 77 ms, half of it after 91 to 135 ms.
   */
  public double rcYawDelay() {
    return pick(0.15, 0.05);
  }

  /** Time constant of the turning rate [s]. Measured: 0.1 to 0.2, and as above. */
  public double rcYawTimeConstant() {
    return pick(0.15, 0.02);
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
    return StrictMath.toRadians(pick(value, measuredYawRateDeg(value)));
  }

  private static double measuredYawRateDeg(double value) {
    double size = Math.abs(value);
    for (int i = 1; i < YAW_VALUES.length; i++) {
      if (size <= YAW_VALUES[i]) {
        double part = (size - YAW_VALUES[i - 1]) / (YAW_VALUES[i] - YAW_VALUES[i - 1]);
        return Math.copySign(YAW_RATES[i - 1] + part * (YAW_RATES[i] - YAW_RATES[i - 1]), value);
      }
    }
    return Math.copySign(YAW_RATES[YAW_RATES.length - 1], value);
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
