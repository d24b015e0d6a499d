package tellosimulator.pilot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A sequence of commands, the path along which the commands move the drone, and the drone's final
 * pose.
 */
final class FlightPlan {

  /** Minimum distance of a {@code go} in at least one direction [cm]. Documented: SDK 2.0. */
  private static final int SHORTEST_CM = 20;

  /** Maximum distance of a {@code go} in each direction [cm]. Documented: SDK 2.0. */
  private static final int LONGEST_CM = 500;

  /** Speed of a {@code go} and a {@code curve} [cm/s]. Decided: lively, but easy to watch. */
  private static final int SPEED_CM = 60;

  /**
   * Distance by which a {@code flip} moves the drone in the direction of the flip [cm]. Measured:
   * about 30 cm.
   */
  static final int FLIP_CM = 30;

  /** Climb during a {@code flip} [m]. Measured in the simulation. */
  private static final double FLIP_RISE = 0.44;

  /** Number of straight segments that approximate a half circle in the path. */
  private static final int ARC_PARTS = 12;

  private final List<String> commands = new ArrayList<>();
  private final List<Vec3> path = new ArrayList<>();
  private Vec3 position;
  private double heading;

  private FlightPlan(Vec3 position, double heading) {
    this.position = position;
    this.heading = heading;
  }

  /** Returns an empty plan for a standing drone. */
  static FlightPlan from(Pose pose) {
    return new FlightPlan(pose.position(), pose.attitude().heading());
  }

  /**
   * Returns a copy of the plan, for trying a continuation. The path of the copy begins at the
   * current position, so that only the continuation is checked for obstacles.
   */
  FlightPlan copy() {
    FlightPlan copy = new FlightPlan(position, heading);
    copy.commands.addAll(commands);
    copy.path.add(position);
    return copy;
  }

  /** Returns the corners of the path in the room frame [m]. Straight lines connect them. */
  List<Vec3> path() {
    return List.copyOf(path);
  }

  /** Returns the final position of the drone in the room frame [m]. */
  Vec3 position() {
    return position;
  }

  /** Returns the final pose of the drone, which hovers. */
  Pose pose() {
    return new Pose(position, Attitude.ofHeading(heading));
  }

  /** Returns whether the drone is on the ground at the end. */
  boolean landed() {
    return !commands.contains("takeoff") || commands.get(commands.size() - 1).equals("land");
  }

  List<String> commands() {
    return List.copyOf(commands);
  }

  /** Adds a command that does not move the drone. */
  FlightPlan say(String command) {
    commands.add(command);
    return this;
  }

  /** Takes off to a height above the ground [m]. */
  FlightPlan takeoff(double height) {
    position = position.withZ(position.z() + height);
    path.add(position);
    return say("takeoff");
  }

  /** Lands at a place below the drone. The next takeoff begins there. */
  FlightPlan landOn(Vec3 place) {
    position = place;
    return say("land");
  }

  /**
   * Flies straight to a place in the room frame [m]. Adds no command if the place is too near for a
   * {@code go}.
   */
  FlightPlan goTo(Vec3 place) {
    Vec3 way = place.minus(position).turned(-heading);
    int x = cm(way.x());
    int y = cm(way.y());
    int z = cm(way.z());
    if (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) > LONGEST_CM) {
      return goTo(position.plus(place).times(0.5)).goTo(place);
    }
    if (x == 0 && y == 0 && Math.abs(z) >= SHORTEST_CM) {
      return move(z > 0 ? "up" : "down", new Vec3(0, 0, Math.signum(z)), Math.abs(z));
    }
    if (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) > SHORTEST_CM) {
      advance(new Vec3(x, y, z));
      say(text("go %d %d %d %d", x, y, z, SPEED_CM));
    }
    return this;
  }

  FlightPlan forward(int distanceCm) {
    return move("forward", new Vec3(1, 0, 0), distanceCm);
  }

  FlightPlan right(int distanceCm) {
    return move("right", new Vec3(0, -1, 0), distanceCm);
  }

  /** Turns clockwise seen from above. */
  FlightPlan clockwise(int degrees) {
    heading = Frames.wrapped(heading + Frames.headingOfYaw(degrees));
    return say(degrees < 0 ? text("ccw %d", -degrees) : text("cw %d", degrees));
  }

  /** Turns the nose to a place in the room frame [m]. */
  FlightPlan turnTo(Vec3 place) {
    Vec3 way = place.minus(position);
    double left = Frames.wrapped(StrictMath.atan2(way.y(), way.x()) - heading);
    int degrees = (int) Math.round(Frames.yawOfHeading(left));
    return degrees == 0 ? this : clockwise(degrees);
  }

  /** Flies half a circle that starts straight ahead and ends to the left of its start. */
  FlightPlan halfCircleToTheLeft(int radiusCm) {
    Vec3 start = position;
    for (int i = 1; i <= ARC_PARTS; i++) {
      double angle = Math.PI * i / ARC_PARTS;
      position = start;
      advance(new Vec3(StrictMath.sin(angle), 1 - StrictMath.cos(angle), 0).times(radiusCm));
    }
    return say(text("curve %d %d 0 0 %d 0 %d", radiusCm, radiusCm, 2 * radiusCm, SPEED_CM));
  }

  FlightPlan flipForward() {
    path.add(position.plusScaled(Vec3.UP, FLIP_RISE));
    advance(new Vec3(FLIP_CM, 0, 0));
    return say("flip f");
  }

  private FlightPlan move(String verb, Vec3 direction, int distanceCm) {
    advance(direction.times(distanceCm));
    return say(text("%s %d", verb, distanceCm));
  }

  private void advance(Vec3 wayCm) {
    position = position.plus(wayCm.times(Frames.meters(1)).turned(heading));
    path.add(position);
  }

  private static int cm(double meters) {
    return (int) Math.round(Frames.centimeters(meters));
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
