package tellosimulator.controller;

import tellosimulator.command.Command;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sensor.SeededNoise.Channel;

/**
 * Plans the path from where a drone is to where a command sends it, as exactly as the behaviour has
 * it. For one drone and the simulation thread.
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
   * Straight by a way in the level body frame.
   *
   * @param way metres
   * @param speed metres per second
   */
  Maneuver by(Vec3 way, double speed) {
    return to(flight.basePosition().plus(way.turned(flight.baseHeading())), speed);
  }

  /**
   * Straight to a place; heights at which no drone hovers become the nearest at which one does.
   *
   * @param place room frame [m]
   * @param speed metres per second
   */
  Maneuver to(Vec3 place, double speed) {
    Vec3 goal = place.plus(miss());
    double lowest = context.behavior().lowestHover();
    double height = Math.max(lowest, Math.min(DroneSpec.MAX_HEIGHT, goal.z()));
    Path path = Path.Line.between(flight.basePosition(), goal.withZ(height));
    return new PathFlight(path, speed, flight.baseHeading());
  }

  /** Whether the drone gets to a place, and not only as low as it hovers. */
  boolean reaches(Vec3 place) {
    return context.behavior().answersLowDown() || place.z() >= context.behavior().lowestHover();
  }

  /**
   * Along an arc from here.
   *
   * @param turn heading of the arc's axes [rad]
   */
  Maneuver along(Command.Curve curve, double turn) {
    Path path = new Path.Curve(flight.basePosition(), curve.arc(), turn, miss());
    return new PathFlight(path, curve.speed(), flight.baseHeading());
  }

  /**
   * On the spot.
   *
   * @param angle counter-clockwise seen from above [rad]
   */
  Maneuver turn(double angle) {
    double miss = miss(Channel.MOVE_HEADING, context.behavior().headingSigma());
    moves++;
    return new Turn(flight.basePosition(), flight.baseHeading(), angle + miss);
  }

  /** By how much the next motion ends elsewhere [m]. */
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
}
