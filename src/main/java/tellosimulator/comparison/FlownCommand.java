package tellosimulator.comparison;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.math.Vec3;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.ReportedState;

/**
 * A command and the drone's motion until the reply. Immutable.
 *
 * @param command the command with its reply
 * @param motion the motion according to the state lines; empty if there are too few lines
 */
public record FlownCommand(RecordedCommand command, Optional<Motion> motion) {

  /**
   * The displacement of a drone, in the drone's frame at the time of the command.
   *
   * @param forward displacement in the direction of the nose [cm]
   * @param left displacement to the left [cm]
   * @param up displacement upwards [cm]
   * @param turn change in yaw, clockwise seen from above, from -180 to 180 [degrees]
   */
  public record Motion(double forward, double left, double up, double turn) {}

  private static final double CENTIMETERS = 100;

  /**
   * Determines the motion that belongs to a command.
   *
   * @param states the drone's states, in order of time
   */
  static FlownCommand of(RecordedCommand command, List<ReportedState> states) {
    OptionalDouble answered = command.answered();
    if (answered.isEmpty()) {
      return new FlownCommand(command, Optional.empty());
    }
    int from = firstAt(states, command.sent());
    int to = firstAt(states, Math.nextUp(answered.getAsDouble()));
    List<ReportedState> during = states.subList(from, Math.max(from, to));
    return new FlownCommand(
        command, during.size() < 2 ? Optional.empty() : Optional.of(motion(during)));
  }

  /** Returns the index of the first state that is not earlier than a time. */
  private static int firstAt(List<ReportedState> states, double time) {
    int low = 0;
    int high = states.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (states.get(middle).time() < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private static Motion motion(List<ReportedState> states) {
    ReportedState first = states.get(0);
    ReportedState last = states.get(states.size() - 1);
    double ahead = 0;
    double right = 0;
    for (int i = 1; i < states.size(); i++) {
      double seconds = states.get(i).time() - states.get(i - 1).time();
      Vec3 mean = states.get(i - 1).velocity().plus(states.get(i).velocity()).times(0.5);
      ahead += mean.x() * seconds;
      right += mean.y() * seconds;
    }
    double yaw = Math.toRadians(first.yawDeg());
    double cos = Math.cos(yaw);
    double sin = Math.sin(yaw);
    return new Motion(
        CENTIMETERS * (ahead * cos + right * sin),
        CENTIMETERS * (ahead * sin - right * cos),
        last.heightCm() - first.heightCm(),
        wrapped(last.yawDeg() - first.yawDeg()));
  }

  /** Wraps an angle to the range from -180 to 180 [degrees]. */
  static double wrapped(double degrees) {
    return Math.IEEEremainder(degrees, 360);
  }
}
