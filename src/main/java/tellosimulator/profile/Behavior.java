package tellosimulator.profile;

import java.util.Locale;

/**
 * The reference model of the drone: it settles the points on which the sources about the real drone
 * differ. Each method stands for one of these points, and gives its values in the order {@link
 * #REPORT}, {@link #MEASURED}.
 *
 * <p>"Report" stands for the FHNW report of 2020 on a real Tello EDU. "Measured" stands for
 * published measurements of real drones that go beyond the report. {@code docs/protocol.md} names
 * the sources.
 */
public enum Behavior {
  REPORT,
  MEASURED;

  /**
   * Yaw values of {@code rc} for which the yaw rates are known. Rates between them are interpolated
   * linearly. Measured: three flights of pgminin/tello-vision-telemetry-lab. The rate at full stick
   * (1.55 rad/s) is from a calibrated ROS controller.
   */
  private static final double[] YAW_VALUES = {0, 3, 5, 10, 20, 40, 45, 100};

  /** Yaw rates that correspond to {@link #YAW_VALUES} [degrees/s]. */
  private static final double[] YAW_RATES = {0, 0, 1, 4.5, 11, 25, 30, 89};

  private <T> T pick(T report, T measured) {
    return this == REPORT ? report : measured;
  }

  /** Returns the height of a takeoff above the floor [m]. */
  public double takeoffHeight() {
    return pick(0.30, 0.80);
  }

  /**
   * Returns the climb speed at takeoff [m/s]. Measured: the peak climb speed is 0.8 m/s. Assumed:
   * 0.35 m/s for the report's takeoff to 30 cm.
   */
  public double takeoffSpeed() {
    return pick(0.35, 0.80);
  }

  /**
   * Returns the height gained by the slow rise after a takeoff [m]. Measured: the drone is at 80 cm
   * after 2.2 s, and at 94 cm after 4.3 s.
   */
  public double takeoffCreep() {
    return pick(0.0, 0.08);
  }

  /**
   * Returns the minimum time from {@code takeoff} to {@code ok} [s]. Report: 3.0 s. Measured: 5.5
   * s.
   */
  public double takeoffTime() {
    return pick(3.0, 5.5);
  }

  /**
   * Returns the time from {@code land} to the first descent [s]. Measured: 0.75 s
   * (xg590/Tello-Python). Assumed for the report: the value for which a whole landing from 80 cm
   * takes 3.0 s.
   */
  public double landingDelay() {
    return pick(0.45, 0.75);
  }

  /**
   * Returns the time from the stop of the motors after a landing to {@code ok} [s]. Measured: 1.1
   * to 1.4 s after touchdown on one drone, and hardly any time on another. With 0.75 s, the
   * duration of a landing from 80 cm agrees with the 3.0 s of the report within a quarter.
   */
  public double landingSettle() {
    return pick(0.1, 0.75);
  }

  /**
   * Returns the time for which a drone must be still on its target before it replies {@code ok}
   * [s]. Report: the drone settles first. Measured: {@code ok} comes when the speed reaches 0
   * (xg590/Tello-Python, four moves).
   */
  public double steadyTime() {
    return pick(0.3, 0.0);
  }

  /**
   * Returns the standard deviation of the end position of a move [m]. Measured: moves end within ±5
   * cm.
   */
  public double positionSigma() {
    return pick(0.0, 0.025);
  }

  /**
   * Returns the standard deviation of the end heading of a turn [rad]. Measured: a turn of 90
   * degrees ends at 89 to 90 degrees.
   */
  public double headingSigma() {
    return pick(0.0, StrictMath.toRadians(1));
  }

  /**
   * Whether sensors are noisy, {@code h} has an offset, yaw drifts and the period of the state line
   * jitters.
   */
  public boolean noisySensors() {
    return pick(false, true);
  }

  /**
   * Returns the largest horizontal {@code rc} value without an effect. Report: a value of 20 does
   * not move the drone.
   */
  public double rcDeadZone() {
    return pick(20.0, 0.0);
  }

  /** Returns the horizontal speed per unit of {@code rc} [m/s]. */
  public double rcLevelGain() {
    return pick(0.010, 0.015);
  }

  /**
   * Returns the delay from a horizontal {@code rc} to the beginning of the tilt [s]. Measured:
   * TelloPy 0.7.0, docs/sensor_time.md. The tilt reaches a tenth of its final angle after 165 ms,
   * and half of it after 249 to 266 ms.
   */
  public double rcLevelDelay() {
    return pick(0.35, 0.10);
  }

  /**
   * Returns the time constant with which a horizontal {@code rc} builds up acceleration [s]; 0 for
   * an immediate response. Measured: the source is that of {@link #rcLevelDelay}. The onset
   * accounts for the part of the measured delay that is not dead time.
   */
  public double rcLevelOnset() {
    return pick(0.0, 0.06);
  }

  /** Returns the time constant of the horizontal response to {@code rc} [s]. */
  public double rcLevelTimeConstant() {
    return 0.6;
  }

  /**
   * Returns the delay from a yaw {@code rc} to the beginning of the turn [s]. Measured: the source
   * is that of {@link #rcLevelDelay}. The gyroscope shows half of the yaw rate 91 to 108 ms after
   * the packet was sent, which includes the link, and the rate controller.
   */
  public double rcYawDelay() {
    return pick(0.15, 0.01);
  }

  /**
   * Returns the time constant of the yaw rate [s]. Measured: 0.1 to 0.2 s, used for {@link
   * #REPORT}; {@link #MEASURED} follows from the times given at {@link #rcYawDelay}.
   */
  public double rcYawTimeConstant() {
    return pick(0.15, 0.02);
  }

  /** Returns the vertical speed per unit of {@code rc} [m/s]. */
  public double rcVerticalGain() {
    return 0.010;
  }

  /**
   * Returns the yaw rate for a yaw value of {@code rc} [rad/s]. The rate has the same sign as the
   * value. Report: the rate is one degree per second per unit. Measured: the rate follows a
   * progressive curve through published points.
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

  /** Returns the lowest height at which the drone hovers [m]. Measured: 27 to 28 cm. */
  public double lowestHover() {
    return pick(0.10, 0.28);
  }

  /**
   * Whether a move that is stopped at {@link #lowestHover} counts as completed. If not, {@code
   * down} is never answered, and a flight relative to a pad ends with {@code error Run timeout}.
   */
  public boolean answersLowDown() {
    return pick(true, false);
  }

  /**
   * Returns the range of the forward sensor of the extension board [m]. Report: just under 8192 mm,
   * because a reading of 8192 mm means that nothing is within range (SDK 3.0 User Guide). Measured:
   * at most 2 m, the range of the board's VL53L0X (the board's firmware RMTT_TOF; ST's data sheet).
   */
  public double boardRange() {
    return pick(8.191, 2.0);
  }

  /**
   * Whether the drone carries out {@code land} while another command runs, instead of refusing it.
   */
  public boolean landsWhileBusy() {
    return pick(false, true);
  }

  /** Whether the drone answers read commands and {@code command} while another command runs. */
  public boolean readsWhileBusy() {
    return pick(false, true);
  }

  /**
   * Whether {@code wifi}, {@code ap} and {@code wifisetchannel} restart the drone, as they restart
   * the real one.
   */
  public boolean restartsForNetwork() {
    return pick(false, true);
  }

  /** Returns the time that a full battery lasts in flight while video is sent [s]. */
  public double filmingEndurance() {
    return pick(13.0, 7.5) * 60;
  }

  /** Returns the word that selects this behaviour on the command line. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }
}
