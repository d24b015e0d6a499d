package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** A hover: the drone brakes from its current movement and stays in place. Never ends. */
final class Hover implements Maneuver {

  private final Setpoint.Heading heading;
  private Vec3 position;
  private Vec3 velocity;

  /**
   * Creates a hover.
   *
   * @param position the position to hold or, if the drone is moving, the position at which braking
   *     begins, in the room frame [m]
   * @param velocity the velocity at which braking begins [m/s]
   * @param heading the direction of the nose [rad]
   */
  Hover(Vec3 position, Vec3 velocity, double heading) {
    this.position = position;
    this.velocity = velocity;
    this.heading = new Setpoint.Heading(heading, 0);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    double speed = velocity.norm();
    double loss = DroneSpec.HARD_BRAKING * seconds;
    if (speed <= loss || sensed.blocked()) {
      velocity = Vec3.ZERO;
      return new Setpoint.Track(position, Vec3.ZERO, Vec3.ZERO, heading);
    }
    Vec3 braking = velocity.times(-DroneSpec.HARD_BRAKING / speed);
    velocity = velocity.plusScaled(braking, seconds);
    position = position.plusScaled(velocity, seconds);
    return new Setpoint.Track(position, velocity, braking, heading);
  }

  @Override
  public boolean planned() {
    return false;
  }

  @Override
  public boolean atRest() {
    return velocity.equals(Vec3.ZERO);
  }

  @Override
  public Phrase progress() {
    return Phrase.of("hovering");
  }
}
