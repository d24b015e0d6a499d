package tellosimulator.controller;

import tellosimulator.math.Frames;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.SimTime;

/**
 * Detects when a drone has settled on its target. One instance per drone, confined to the
 * simulation thread.
 */
final class Settling {

  /**
   * Maximum distance from the target [m]. Decided: slightly less than the 1 cm within which a move
   * ends ({@code docs/protocol.md}).
   */
  private static final double DISTANCE = 0.006;

  /**
   * Maximum heading error [rad]. Decided: slightly less than the 0.5 degrees within which a move
   * ends.
   */
  private static final double HEADING = StrictMath.toRadians(0.4);

  /**
   * Maximum speed [m/s]. Decided: slightly less than the 5 cm/s allowed at the time of {@code ok}.
   */
  private static final double SPEED = 0.03;

  /** Time after which a drone in wind only has to be near its target [s]. Assumed. */
  private static final double SHAKEN = 2;

  /** Maximum distance at which a drone in wind counts as near its target [m]. Assumed. */
  private static final double ABOUT = 0.15;

  /** Maximum speed at which a drone in wind counts as near its target [m/s]. Assumed. */
  private static final double SHAKING = 0.3;

  /** Time after which the drone gives up settling [s]. Assumed. */
  private static final double PATIENCE = 8;

  private final double steadyTime;
  private double steady;
  private double waited;

  /**
   * Creates the detector for a drone.
   *
   * @param steadyTime the required time on the target [s]; with 0, reaching the target once is
   *     enough
   */
  Settling(double steadyTime) {
    this.steadyTime = steadyTime;
  }

  void restart() {
    steady = 0;
    waited = 0;
  }

  /**
   * Evaluates the end of a step.
   *
   * @param steered whether sticks or a drift move the target; if so, the drone counts as on its
   *     target
   * @param pushed whether wind pushes the drone
   */
  void observe(Setpoint setpoint, Motion motion, boolean steered, boolean pushed) {
    waited += SimTime.STEP;
    boolean shaken = pushed && waited >= SHAKEN;
    steady = steered || near(setpoint, motion, shaken) ? steady + SimTime.STEP : 0;
  }

  boolean settled() {
    return steady > 0 && steady >= steadyTime;
  }

  boolean givenUp() {
    return waited >= PATIENCE;
  }

  private static boolean near(Setpoint setpoint, Motion motion, boolean shaken) {
    if (!(setpoint instanceof Setpoint.Track track)) {
      return true;
    }
    double drift = motion.velocity().minus(track.velocity()).norm();
    double distance = motion.position().distanceTo(track.position());
    double turn = Frames.wrapped(track.heading().angle() - motion.attitude().heading());
    return distance < (shaken ? ABOUT : DISTANCE)
        && drift < (shaken ? SHAKING : SPEED)
        && Math.abs(turn) < HEADING;
  }
}
