package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** Flies along a path with a steady heading: the six directions, {@code go} and {@code curve}. */
final class PathFlight implements Maneuver {

  /**
   * How far ahead of the plan the drone tilts [s]: twice the damping over the frequency of the
   * tilt, which is how long the tilt lags behind.
   */
  private static final double ANTICIPATION = 2 * DroneSpec.DAMPING / DroneSpec.TILT_FREQUENCY;

  private final Path path;
  private final SpeedProfile profile;
  private final Setpoint.Heading heading;
  private double time = -DroneSpec.MOVE_DELAY;

  /**
   * @param speed limit along the path [m/s]
   * @param heading where the nose points all the way [rad]
   */
  PathFlight(Path path, double speed, double heading) {
    this.path = path;
    double peak = DroneSpec.PEAK_SPEED_OVER_ONE_METER * Math.sqrt(path.length());
    this.profile =
        SpeedProfile.over(
            path.length(), Math.min(speed, peak), DroneSpec.ACCELERATION, DroneSpec.BRAKING);
    this.heading = new Setpoint.Heading(heading, 0);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    if (!sensed.blocked()) {
      time += seconds;
    }
    Setpoint.Track now = path.track(profile.at(time), heading);
    return new Setpoint.Track(now.position(), now.velocity(), acceleration(now), heading);
  }

  /** The level part of what is needed soon, because tilt lags, and the vertical part of now. */
  private Vec3 acceleration(Setpoint.Track now) {
    double soon = time + ANTICIPATION;
    return soon < 0
        ? Vec3.ZERO
        : path.track(profile.at(soon), heading).acceleration().withZ(now.acceleration().z());
  }

  @Override
  public boolean planned() {
    return time >= profile.duration();
  }

  @Override
  public Phrase progress() {
    if (planned()) {
      return Phrase.of("it has arrived and balances out");
    }
    double way = profile.at(time).way();
    return Phrase.of("%.0f of %.0f cm flown", way * 100, path.length() * 100);
  }
}
