package tellosimulator.physics;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;
import tellosimulator.physics.Integrator.Forces;

/**
 * The dynamics of a quadcopter: thrust along the body's z axis, gravity, drag against the air, and
 * a second-order attitude response. Tilt, accelerometer readings and the loop of a flip follow from
 * it. For one drone and one thread; the same inputs give the same motion, bit for bit.
 */
public final class QuadcopterDynamics {

  private static final double GREATEST_THRUST = DroneSpec.MAX_THRUST_RATIO * DroneSpec.GRAVITY;

  private final PositionLoop positionLoop = new PositionLoop();
  private final AttitudeLoop attitudeLoop = new AttitudeLoop();
  private final Integrator integrator = new Integrator();
  private final WindEstimator windEstimator = new WindEstimator();

  /**
   * The motion a step later, as if nothing stood in the way.
   *
   * @param wind velocity of the air, room frame [m/s]
   * @param seconds length of the step
   */
  public Motion advance(Motion motion, Setpoint setpoint, Vec3 wind, double seconds) {
    Motion next = integrator.step(motion, forces(motion, setpoint, wind), seconds);
    windEstimator.update(motion.velocity(), wind, seconds);
    return next;
  }

  /** The body rests for a step: it does not move, and does not feel the wind. */
  public void rest() {
    windEstimator.reset();
  }

  /** Whether wind pushes it, as far as the drone itself feels that. */
  public boolean pushed() {
    return !windEstimator.push().equals(Vec3.ZERO);
  }

  private Forces forces(Motion motion, Setpoint setpoint, Vec3 wind) {
    if (setpoint instanceof Setpoint.Track track) {
      Vec3 wanted = positionLoop.thrust(track, motion, windEstimator.push());
      double along = wanted.dot(motion.attitude().up());
      double thrust = Math.max(0, Math.min(GREATEST_THRUST, along));
      return new Forces(thrust, attitudeLoop.towards(wanted, track.heading(), motion), wind);
    }
    if (setpoint instanceof Setpoint.Spin spin) {
      double thrust = spin.thrustRatio() * DroneSpec.GRAVITY;
      return new Forces(thrust, attitudeLoop.towards(spin, motion), wind);
    }
    return new Forces(0, Vec3.ZERO, wind);
  }
}
