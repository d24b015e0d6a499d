package tellosimulator.recording;

import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.time.SimTime;

/**
 * What became of the goals, and when the try at them began. Immutable.
 *
 * @param begun from when the seconds of the progress count
 */
record GoalResult(Progress progress, SimTime begun) {

  /**
   * What is known now.
   *
   * @param before what was known before, in the same flight
   */
  static GoalResult latest(Optional<GoalResult> before, Progress progress, SimTime now) {
    boolean over = progress.status() != Status.RUNNING && before.isPresent();
    long begun = now.nanos() - Math.round(progress.elapsed() * 1e9);
    return new GoalResult(progress, over ? before.get().begun : new SimTime(Math.max(0, begun)));
  }

  /** In a word, as files have it. */
  String word() {
    if (progress.challenge().goals().isEmpty()) {
      return "none";
    }
    return switch (progress.status()) {
      case REACHED -> "reached";
      case FAILED -> "missed";
      case RUNNING -> "open";
    };
  }

  /** When a goal was reached, by its index; empty if it was not [simulated s]. */
  OptionalDouble reached(int goal) {
    OptionalDouble after = progress.reached().get(goal);
    return after.isPresent()
        ? OptionalDouble.of(begun.seconds() + after.getAsDouble())
        : OptionalDouble.empty();
  }
}
