package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.words.Phrase;

/**
 * A landing: the drone descends until it stands on something, stops the motors and waits a moment.
 */
final class Landing implements Maneuver {

  /** Acceleration and deceleration of the descent [m/s²]. Assumed. */
  private static final double ACCELERATION = 2;

  /** Time on the ground before the motors stop [s]. Assumed. */
  private static final double CONTACT = 0.1;

  /** Maximum depth of the target below the drone [m]. Assumed. */
  private static final double LEAD = 0.05;

  private final Setpoint.Heading heading;
  private final Behavior behavior;
  private Vec3 target;
  private double speed;
  private double time;
  private double contact;
  private double settled;

  /**
   * Creates a landing.
   *
   * @param start the drone's position, in the room frame [m]
   * @param heading the direction of the nose [rad]
   */
  Landing(Vec3 start, double heading, Behavior behavior) {
    this.target = start;
    this.behavior = behavior;
    this.heading = new Setpoint.Heading(heading, 0);
  }

  /** Whether the drone stands on something with its motors off. */
  boolean down() {
    return contact >= CONTACT;
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    time += seconds;
    if (down()) {
      settled += seconds;
      return new Setpoint.MotorsOff();
    }
    contact = sensed.onGround() ? contact + seconds : 0;
    double height = sensed.motion().position().z();
    if (time > behavior.landingDelay()) {
      double limit =
          height > DroneSpec.SLOW_LANDING_HEIGHT
              ? DroneSpec.LANDING_SPEED
              : DroneSpec.SLOW_LANDING_SPEED;
      double change = ACCELERATION * seconds;
      speed = speed > limit ? Math.max(limit, speed - change) : Math.min(limit, speed + change);
    }
    double lowest = height - LEAD;
    target = target.withZ(Math.max(lowest, target.z() - speed * seconds));
    return new Setpoint.Track(target, new Vec3(0, 0, -speed), Vec3.ZERO, heading);
  }

  @Override
  public boolean planned() {
    return settled >= behavior.landingSettle();
  }

  @Override
  public Phrase progress() {
    return down() ? Phrase.of("the motors are stopping") : Phrase.of("on the way down");
  }

  @Override
  public boolean steerable() {
    return false;
  }

  @Override
  public boolean leavesHoverHeights() {
    return true;
  }
}
