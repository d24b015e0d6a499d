package tellosimulator.junit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Progress;

/**
 * The drones' progress towards the goals of the scenario. Immutable.
 *
 * @param reached whether the scenario has goals and all of them are reached
 * @param failed whether the goals can no longer be reached
 * @param reason the reason for the failure, in plain words; empty unless the goals failed
 * @param done the reached goals, in words
 * @param open the remaining goals, in words
 * @param seconds the time since the first takeoff [simulated s]; stops when the outcome is final
 * @param score the points; empty if the scenario has none
 */
public record GoalStatus(
    boolean reached,
    boolean failed,
    String reason,
    List<String> done,
    List<String> open,
    double seconds,
    Optional<ScoreStatus> score) {

  public GoalStatus {
    done = List.copyOf(done);
    open = List.copyOf(open);
  }

  static GoalStatus of(Progress progress) {
    List<String> done = new ArrayList<>();
    List<String> open = new ArrayList<>();
    for (int i = 0; i < progress.reached().size(); i++) {
      Goal goal = progress.challenge().goals().get(i);
      String words = (i + 1) + ". " + goal.phrase().english();
      (progress.reached().get(i).isPresent() ? done : open).add(words);
    }
    return new GoalStatus(
        progress.status() == Progress.Status.REACHED,
        progress.status() == Progress.Status.FAILED,
        progress.failure().map(reason -> reason.english()).orElse(""),
        done,
        open,
        progress.elapsed(),
        progress.score().map(ScoreStatus::of));
  }

  /** Returns whether the goals have failed, or a drone has flown and goals remain. */
  boolean missed() {
    return failed || (seconds > 0 && !open.isEmpty());
  }

  /** Summarizes the progress in one line. */
  @Override
  public String toString() {
    if (done.isEmpty() && open.isEmpty()) {
      return "the scenario has no goals";
    }
    int all = done.size() + open.size();
    String count = done.size() + " of " + all + " goals reached";
    String next = open.isEmpty() ? "" : "; open: " + String.join("; ", open);
    String points = score.map(each -> "; score: " + each).orElse("");
    return count + (failed ? "; failed: " + reason : "") + next + points;
  }
}
