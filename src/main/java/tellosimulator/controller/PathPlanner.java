package tellosimulator.controller;

import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.Setpoint;
import tellosimulator.sensor.SeededNoise.Channel;
import tellosimulator.words.Phrase;

/**
 * Plans the path from a drone's position to the goal of a command, including the behaviour's
 * positioning error. One instance per drone, confined to the simulation thread.
 */
final class PathPlanner {

  private final ControllerContext context;
  private final Flight flight;
  private long moves;

  PathPlanner(ControllerContext context, Flight flight) {
    this.context = context;
    this.flight = flight;
  }

  /**
   * Plans a straight path along a displacement in the level body frame.
   *
   * @param way the displacement [m]
   * @param speed the speed [m/s]
   */
  Maneuver by(Vec3 way, double speed) {
    return to(flight.basePosition().plus(way.turned(flight.baseHeading())), speed);
  }

  /**
   * Plans a straight path to a place. The height of the place is limited to the hover heights.
   *
   * @param place the place, in the room frame [m]
   * @param speed the speed [m/s]
   */
  Maneuver to(Vec3 place, double speed) {
    Vec3 goal = place.plus(miss());
    double lowest = context.behavior().lowestHover();
    double height = Math.max(lowest, Math.min(DroneSpec.MAX_HEIGHT, goal.z()));
    Path path = Path.Line.between(flight.basePosition(), goal.withZ(height));
    return new PathFlight(path, speed, flight.baseHeading());
  }

  /**
   * Whether a flight to a place can complete. In some behaviours, a place below the lowest hover
   * height is unreachable.
   */
  boolean reaches(Vec3 place) {
    return context.behavior().answersLowDown() || place.z() >= context.behavior().lowestHover();
  }

  /**
   * Plans a path along an arc from the current position.
   *
   * @param speed the speed [m/s]
   * @param turn the heading of the arc's axes [rad]
   */
  Maneuver along(Arc arc, double speed, double turn) {
    Path path = new Path.Curve(flight.basePosition(), arc, turn, miss());
    return new PathFlight(path, speed, flight.baseHeading());
  }

  /**
   * Plans a turn on the spot.
   *
   * @param angle the angle, counter-clockwise seen from above [rad]
   */
  Maneuver turn(double angle) {
    double miss = miss(Channel.MOVE_HEADING, context.behavior().headingSigma());
    moves++;
    return new Turn(flight.basePosition(), flight.baseHeading(), angle + miss);
  }

  /** Draws the position error at the end of the next movement, in the room frame [m]. */
  Vec3 miss() {
    double sigma = context.behavior().positionSigma();
    Vec3 miss =
        new Vec3(
            miss(Channel.MOVE_X, sigma), miss(Channel.MOVE_Y, sigma), miss(Channel.MOVE_Z, sigma));
    moves++;
    return miss;
  }

  private double miss(Channel channel, double sigma) {
    return sigma == 0 ? 0 : sigma * context.noise().gaussian(channel, moves);
  }

  /**
   * A flight along a path with a constant heading: the moves in the six directions, {@code go} and
   * {@code curve}.
   */
  private static final class PathFlight implements Maneuver {

    /**
     * Time by which the drone tilts ahead of the plan [s]. It equals the lag of the tilt: twice the
     * damping ratio divided by the natural frequency of the tilt.
     */
    private static final double ANTICIPATION = 2 * DroneSpec.DAMPING / DroneSpec.TILT_FREQUENCY;

    private final Path path;
    private final SpeedProfile profile;
    private final Setpoint.Heading heading;
    private double time = -DroneSpec.MOVE_DELAY;

    /**
     * Creates a flight along a path.
     *
     * @param speed the maximum speed along the path [m/s]
     * @param heading the direction of the nose on the whole path [rad]
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

    /**
     * Returns the target acceleration [m/s²]: horizontally the path's acceleration {@link
     * #ANTICIPATION} from now, because the tilt lags; vertically the path's acceleration now.
     */
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
        return Phrase.of("it has arrived and is stabilising");
      }
      double way = profile.at(time).way();
      return Phrase.of("%.0f of %.0f cm flown", way * 100, path.length() * 100);
    }
  }
}
