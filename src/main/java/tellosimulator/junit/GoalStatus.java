package tellosimulator.junit;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Progress;

/**
 * How far the drones have come with the goals of the scenario. Immutable.
 *
 * @param reached whether there are goals and all of them are reached
 * @param failed whether they cannot be reached any more
 * @param reason why not, in plain words; empty unless they failed
 * @param done goals that are reached, in words
 * @param open goals that are not, in words
 * @param seconds since the first takeoff, and no further once it is over
 */
public record GoalStatus(
    boolean reached,
    boolean failed,
    String reason,
    List<String> done,
    List<String> open,
    double seconds) {

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
        progress.elapsed());
  }

  /** Whether somebody has flown, and goals are left. */
  boolean missed() {
    return failed || (seconds > 0 && !open.isEmpty());
  }

  /** In a line. */
  @Override
  public String toString() {
    if (done.isEmpty() && open.isEmpty()) {
      return "the scenario has no goals";
    }
    int all = done.size() + open.size();
    String count = done.size() + " of " + all + " goals reached";
    String next = open.isEmpty() ? "" : "; open: " + String.join("; ", open);
    return count + (failed ? "; failed: " + reason : "") + next;
  }
}
