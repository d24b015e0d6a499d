package tellosimulator.controller;

import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;

/** Flies along a path with a steady heading: the six directions, {@code go} and {@code curve}. */
final class PathFlight implements Maneuver {

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
    double peak = DroneSpec.PEAK_SPEED_OVER_ONE_METRE * Math.sqrt(path.length());
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
    return path.track(profile.at(Math.max(0, time)), heading);
  }

  @Override
  public boolean planned() {
    return time >= profile.duration();
  }

  @Override
  public String progress() {
    double way = profile.at(Math.max(0, time)).way();
    return "%.0f of %.0f cm flown".formatted(way * 100, path.length() * 100);
  }
}
