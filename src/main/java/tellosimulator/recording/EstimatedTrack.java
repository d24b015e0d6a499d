package tellosimulator.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * How real drones moved, by dead reckoning: the speeds in their state lines are summed up from
 * where they began. That is all that is known of them; it drifts by some ten centimetres a minute.
 * For one thread.
 */
final class EstimatedTrack {

  /** Longest time between state lines over which the drone kept its speed [s]. Decided. */
  private static final double LONGEST_GAP = 1;

  private final Map<Integer, List<Sample>> samples = new TreeMap<>();

  /** Takes the next line of {@code wire.jsonl}; only state lines matter. */
  void take(Fields line) {
    if (!line.text("kind").equals("state")) {
      return;
    }
    int drone = line.whole("drone").orElse(1);
    String text = line.text("text");
    Optional<ReportedState> state = ReportedState.of(line.moment("t").orElse(0), drone, text);
    if (state.isPresent() && RecordedRun.isNumber(drone)) {
      List<Sample> before = samples.computeIfAbsent(drone, number -> new ArrayList<>());
      before.add(sample(before, state.get(), StateNumbers.of(text)));
    }
  }

  private static Sample sample(List<Sample> before, ReportedState state, Map<String, Double> said) {
    Vec3 told = state.velocity();
    Vec3 velocity = new Vec3(told.x(), -told.y(), -told.z());
    Vec3 place =
        before.isEmpty() ? Vec3.ZERO : moved(before.get(before.size() - 1), state, velocity);
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

  /** How each drone moved, in the order of their numbers. */
  List<Track> tracks() {
    return samples.entrySet().stream()
        .map(entry -> new Track(entry.getKey(), entry.getValue()))
        .toList();
  }
}
