package tellosimulator.view.pilot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A sequence of commands, the path along which it leads, and the pose to which it brings the drone.
 */
final class FlightPlan {

  /** A way shorter than this in each direction is no {@code go} [cm]. Documented: SDK 2.0. */
  private static final int SHORTEST_CM = 20;

  /** The longest way in each direction [cm]. Documented: SDK 2.0. */
  private static final int LONGEST_CM = 500;

  /** Speed of a {@code go} and a {@code curve} [cm/s]. Decided: lively, but easy to watch. */
  private static final int SPEED_CM = 60;

  /** How far a {@code flip} ends in its direction [cm]. Measured: about 30. */
  static final int FLIP_CM = 30;

  /** How high a {@code flip} goes meanwhile [m]. Measured in the simulation. */
  private static final double FLIP_RISE = 0.44;

  /** Straight parts that stand for half a circle where its path is looked at. */
  private static final int ARC_PARTS = 12;

  private final List<String> commands = new ArrayList<>();
  private final List<Vec3> path = new ArrayList<>();
  private Vec3 position;
  private double heading;

  private FlightPlan(Vec3 position, double heading) {
    this.position = position;
    this.heading = heading;
  }

  /** Nothing yet, for a drone that stands. */
  static FlightPlan from(Pose pose) {
    return new FlightPlan(pose.position(), pose.attitude().heading());
  }

  /** The same commands, to go on in another way. Its path begins where they end. */
  FlightPlan copy() {
    FlightPlan copy = new FlightPlan(position, heading);
    copy.commands.addAll(commands);
    copy.path.add(position);
    return copy;
  }

  /** Where the drone flies one after the other, with straight lines between [m, room frame]. */
  List<Vec3> path() {
    return List.copyOf(path);
  }

  /** Where the drone is in the end [m, room frame]. */
  Vec3 position() {
    return position;
  }

  /** Whether the drone does not fly in the end. */
  boolean landed() {
    return !commands.contains("takeoff") || commands.get(commands.size() - 1).equals("land");
  }

  List<String> commands() {
    return List.copyOf(commands);
  }

  /** A command that moves nothing. */
  FlightPlan say(String command) {
    commands.add(command);
    return this;
  }

  /** Up to a height above what it stands on [m]. */
  FlightPlan takeoff(double height) {
    position = position.withZ(position.z() + height);
    path.add(position);
    return say("takeoff");
  }

  /** Down to what is below it, where the next takeoff begins. */
  FlightPlan landOn(Vec3 place) {
    position = place;
    return say("land");
  }

  /** Straight to a place [m, room frame], or not at all if it is nearer than the drone can go. */
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

  /** A turn, clockwise seen from above. */
  FlightPlan clockwise(int degrees) {
    heading = Frames.wrapped(heading + Frames.headingOfYaw(degrees));
    return say(degrees < 0 ? text("ccw %d", -degrees) : text("cw %d", degrees));
  }

  /** Half a circle that leaves straight ahead and ends at the left. */
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
