package tellosimulator.controller;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;

/** Decides when a drone has balanced out on its target. For one drone. */
final class Settling {

  /** Nearest to the target [m], heading [rad] and speed [m/s]. Decided: 1 cm, 0.5°, 5 cm/s. */
  private static final double DISTANCE = 0.006;

  private static final double HEADING = StrictMath.toRadians(0.4);
  private static final double SPEED = 0.03;

  /** How long it must stay so [s]. Measured: about 0.3. */
  private static final double STEADY = 0.3;

  /** After this it gives up [s]. Assumed. */
  private static final double PATIENCE = 8;

  private double steady;
  private double waited;

  void restart() {
    steady = 0;
    waited = 0;
  }

  void observe(Setpoint setpoint, Motion motion, double seconds) {
    waited += seconds;
    steady = near(setpoint, motion) ? steady + seconds : 0;
  }

  boolean settled() {
    return steady >= STEADY;
  }

  boolean givenUp() {
    return waited >= PATIENCE;
  }

  private static boolean near(Setpoint setpoint, Motion motion) {
    if (!(setpoint instanceof Setpoint.Track track)) {
      return true;
    }
    Vec3 drift = motion.velocity().minus(track.velocity());
    double turn = Frames.wrapped(track.heading().angle() - motion.attitude().heading());
    return motion.position().distanceTo(track.position()) < DISTANCE
        && drift.norm() < SPEED
        && Math.abs(turn) < HEADING;
  }
}
