package tellosimulator.recording;

import java.util.OptionalDouble;
import tellosimulator.goal.Progress;

/**
 * What became of the goals, and when the try at them began. Immutable.
 *
 * @param begunNanos from when the seconds of the progress count [simulated ns]
 */
record GoalResult(Progress progress, long begunNanos) {

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
        ? OptionalDouble.of(begunNanos * 1e-9 + after.getAsDouble())
        : OptionalDouble.empty();
  }
}
