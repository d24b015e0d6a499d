package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** A turn on the spot: {@code cw} and {@code ccw}. */
final class Turn implements Maneuver {

  private final Vec3 position;
  private final double start;
  private final double sign;
  private final SpeedProfile profile;
  private double time = -DroneSpec.TURN_DELAY;

  /**
   * Creates a turn.
   *
   * @param position the position to hold, in the room frame [m]
   * @param start the heading at the beginning [rad]
   * @param angle the angle to turn by, counter-clockwise [rad]
   */
  Turn(Vec3 position, double start, double angle) {
    this.position = position;
    this.start = start;
    this.sign = Math.signum(angle);
    this.profile =
        SpeedProfile.over(
            Math.abs(angle),
            DroneSpec.TURN_RATE,
            DroneSpec.TURN_ACCELERATION,
            DroneSpec.TURN_ACCELERATION);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    time += seconds;
    SpeedProfile.Sample sample = profile.at(time);
    Setpoint.Heading heading =
        new Setpoint.Heading(start + sign * sample.way(), sign * sample.speed());
    return new Setpoint.Track(position, Vec3.ZERO, Vec3.ZERO, heading);
  }

  @Override
  public boolean planned() {
    return time >= profile.duration();
  }

  @Override
  public Phrase progress() {
    double way = profile.at(time).way();
    return Phrase.of(
        "%.0f of %.0f degrees turned",
        StrictMath.toDegrees(way), StrictMath.toDegrees(profile.length()));
  }
}
