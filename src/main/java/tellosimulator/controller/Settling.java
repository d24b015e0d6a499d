package tellosimulator.controller;

import tellosimulator.math.Frames;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.SimTime;

/** Decides when a drone has balanced out on its target. For one drone. */
final class Settling {

  /** Greatest distance from the target [m]. Decided: 1 cm when {@code ok} comes, so a bit less. */
  private static final double DISTANCE = 0.006;

  /** Greatest turn from the target [rad]. Decided: 0.5 degrees, so a bit less. */
  private static final double HEADING = StrictMath.toRadians(0.4);

  /** Greatest speed [m/s]. Decided: 5 cm/s, so a bit less. */
  private static final double SPEED = 0.03;

  /** After this a drone that wind shakes need only be about where it shall be [s]. Assumed. */
  private static final double SHAKEN = 2;

  /** What is about there [m, m/s]. Assumed. */
  private static final double ABOUT = 0.15;

  private static final double SHAKING = 0.3;

  /** After this it gives up [s]. Assumed. */
  private static final double PATIENCE = 8;

  private final double steadyTime;
  private double steady;
  private double waited;

  /**
   * @param steadyTime how long it must stay on its target [s]; with 0 it must be there
   */
  Settling(double steadyTime) {
    this.steadyTime = steadyTime;
  }

  void restart() {
    steady = 0;
    waited = 0;
  }

  /**
   * Looks at the end of a step.
   *
   * @param steered whether sticks move the target, so that only time counts
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
