package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.words.Phrase;

/** A takeoff: the drone starts its motors, climbs, and hovers for a moment. */
final class Takeoff implements Maneuver {

  /** Climb acceleration [m/s²]. Measured: the drone reaches 80 cm after 2.2 s. */
  private static final double CLIMB_ACCELERATION = 1.6;

  /** Deceleration at the end of the climb [m/s²]. Measured: the drone reaches 80 cm after 2.2 s. */
  private static final double CLIMB_BRAKING = 0.8;

  /** Duration of the slow rise while hovering [s]. Measured: the rise lasts from 2.2 to 4.3 s. */
  private static final double CREEP_TIME = 2.1;

  private final Path path;
  private final SpeedProfile profile;
  private final double creep;
  private final double planTime;
  private final Setpoint.Heading heading;
  private double time;

  /**
   * Creates a takeoff.
   *
   * @param start the drone's position on the ground, in the room frame [m]
   * @param heading the direction of the nose [rad]
   * @param height the height of the climb [m]
   */
  Takeoff(Vec3 start, double heading, double height, Behavior behavior) {
    this.path = new Path.Line(start, Vec3.UP, height);
    this.profile =
        SpeedProfile.over(
            path.length(), behavior.takeoffSpeed(), CLIMB_ACCELERATION, CLIMB_BRAKING);
    this.creep = behavior.takeoffCreep();
    this.planTime = behavior.takeoffTime() - behavior.steadyTime();
    this.heading = new Setpoint.Heading(heading, 0);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    time += seconds;
    if (spinningUp()) {
      return new Setpoint.MotorsOff();
    }
    double climbing = time - DroneSpec.LIFT_OFF_DELAY;
    Setpoint.Track track = path.track(profile.at(climbing), heading);
    double part = Math.min(1, Math.max(0, (climbing - profile.duration()) / CREEP_TIME));
    return new Setpoint.Track(
        track.position().plusScaled(Vec3.UP, creep * part),
        track.velocity(),
        track.acceleration(),
        heading);
  }

  private boolean spinningUp() {
    return time < DroneSpec.LIFT_OFF_DELAY;
  }

  @Override
  public boolean planned() {
    return time >= planTime;
  }

  @Override
  public Phrase progress() {
    if (time - DroneSpec.LIFT_OFF_DELAY > profile.duration()) {
      return Phrase.of("it is up and balances out");
    }
    double way = profile.at(time - DroneSpec.LIFT_OFF_DELAY).way();
    return Phrase.of("%.0f of %.0f cm climbed", way * 100, path.length() * 100);
  }

  @Override
  public boolean steerable() {
    return !spinningUp();
  }

  @Override
  public boolean leavesHoverHeights() {
    return true;
  }
}
