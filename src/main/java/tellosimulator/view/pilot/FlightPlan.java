package tellosimulator.view.pilot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** A sequence of commands, and the pose to which it brings the drone. */
final class FlightPlan {

  /** A way shorter than this in each direction is no {@code go} [cm]. Documented: SDK 2.0. */
  private static final int SHORTEST_CM = 20;

  /** Speed of a {@code go} and a {@code curve} [cm/s]. Decided: lively, but easy to watch. */
  private static final int SPEED_CM = 60;

  /** How far a {@code flip} ends in its direction [cm]. Measured: about 30. */
  static final int FLIP_CM = 30;

  private final List<String> commands = new ArrayList<>();
  private Vec3 position;
  private double heading;

  /**
   * @param position room frame [m]
   * @param heading where the nose points [rad]
   */
  FlightPlan(Vec3 position, double heading) {
    this.position = position;
    this.heading = heading;
  }

  List<String> commands() {
    return List.copyOf(commands);
  }

  /** A command that moves nothing. */
  FlightPlan say(String command) {
    commands.add(command);
    return this;
  }

  /** Up to a height above the floor [m]. */
  FlightPlan takeoff(double height) {
    position = position.withZ(position.z() + height);
    return say("takeoff");
  }

  /** Straight to a place [m, room frame], or not at all if it is nearer than the drone can go. */
  FlightPlan goTo(Vec3 place) {
    Vec3 way = place.minus(position).turned(-heading);
    int x = cm(way.x());
    int y = cm(way.y());
    int z = cm(way.z());
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
    advance(new Vec3(0, 2 * radiusCm, 0));
    return say(text("curve %d %d 0 0 %d 0 %d", radiusCm, radiusCm, 2 * radiusCm, SPEED_CM));
  }

  FlightPlan flipForward() {
    advance(new Vec3(FLIP_CM, 0, 0));
    return say("flip f");
  }

  private FlightPlan move(String verb, Vec3 direction, int distanceCm) {
    advance(direction.times(distanceCm));
    return say(text("%s %d", verb, distanceCm));
  }

  private void advance(Vec3 wayCm) {
    position = position.plus(wayCm.times(Frames.meters(1)).turned(heading));
  }

  private static int cm(double meters) {
    return (int) Math.round(Frames.centimeters(meters));
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
