package tellosimulator.recording;

import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * The track of a real drone by dead reckoning: it integrates the horizontal velocities in the state
 * lines from the starting point, and takes the height from the same lines. The data allow no better
 * estimate; the track drifts by about ten centimetres a minute. Not thread-safe.
 */
final class EstimatedTrack {

  /**
   * Maximum time between state lines for which the drone is assumed to keep its speed [s]. Decided.
   */
  private static final double LONGEST_GAP = 1;

  private Optional<Sample> last = Optional.empty();

  /**
   * Processes the next state line.
   *
   * @param time the time at which the line was received [s]
   * @return the drone's state at that time; empty if the line contains no motion data
   */
  Optional<Sample> take(double time, int drone, String text) {
    Optional<Sample> sample =
        ReportedState.of(time, drone, text)
            .map(state -> sample(state, ReportedState.numbers(text)));
    last = sample.or(() -> last);
    return sample;
  }

  private Sample sample(ReportedState state, Map<String, Double> said) {
    Vec3 told = state.velocity();
    Vec3 velocity = new Vec3(told.x(), -told.y(), -told.z());
    Vec3 place = last.map(before -> moved(before, state, velocity)).orElse(Vec3.ZERO);
    return new Sample(
        state.time(),
        new Vec3(place.x(), place.y(), Math.max(0, Frames.meters(state.heightCm()))),
        velocity,
        new Sample.Angles(
            said.getOrDefault("roll", 0.0), said.getOrDefault("pitch", 0.0), state.yawDeg()),
        "",
        said.getOrDefault("bat", 0.0),
        "");
  }

  private static Vec3 moved(Sample last, ReportedState state, Vec3 velocity) {
    double seconds = state.time() - last.time();
    boolean gap = seconds < 0 || seconds > LONGEST_GAP;
    Vec3 mean = last.velocity().plus(velocity).times(0.5);
    return gap ? last.position() : last.position().plus(mean.times(seconds));
  }
}
