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
    Optional<ReportedState> state = ReportedState.of(line.numberOr("t", 0), drone, text);
    if (state.isPresent() && RecordedRun.isNumber(drone)) {
      List<Sample> before = samples.computeIfAbsent(drone, number -> new ArrayList<>());
      before.add(sample(before, state.get(), ReportedState.fields(text)));
    }
  }

  private static Sample sample(
      List<Sample> before, ReportedState state, Map<String, String> fields) {
    Vec3 told = state.velocity();
    Vec3 velocity = new Vec3(told.x(), -told.y(), -told.z());
    Vec3 place =
        before.isEmpty() ? Vec3.ZERO : moved(before.get(before.size() - 1), state, velocity);
    return new Sample(
        state.time(),
        new Vec3(place.x(), place.y(), Math.max(0, Frames.metres(state.heightCm()))),
        velocity,
        new Sample.Angles(number(fields, "roll"), number(fields, "pitch"), state.yawDeg()),
        "",
        number(fields, "bat"),
        "");
  }

  private static Vec3 moved(Sample last, ReportedState state, Vec3 velocity) {
    double seconds = state.time() - last.time();
    boolean gap = seconds < 0 || seconds > LONGEST_GAP;
    Vec3 mean = last.velocity().plus(velocity).times(0.5);
    return gap ? last.position() : last.position().plus(mean.times(seconds));
  }

  /** 0 where it is missing, or was corrupted on its way. */
  private static double number(Map<String, String> fields, String name) {
    String value = fields.getOrDefault(name, "");
    return value.matches("-?[0-9]{1,6}([.][0-9]{1,6})?") ? Double.parseDouble(value) : 0;
  }

  /** How each drone moved, in the order of their numbers. */
  List<Track> tracks() {
    return samples.entrySet().stream()
        .map(entry -> new Track(entry.getKey(), entry.getValue()))
        .toList();
  }
}
