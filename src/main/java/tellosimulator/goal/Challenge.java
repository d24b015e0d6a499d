package tellosimulator.goal;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Goals with their rules. A crash always fails it. Immutable.
 *
 * @param goals what to do
 * @param inOrder whether a goal counts only after those before it, and at most one at a moment
 * @param timeLimit seconds from the first takeoff on
 * @param untouched whether a drone that touches anything in flight fails it
 */
public record Challenge(
    List<Goal> goals, boolean inOrder, OptionalDouble timeLimit, boolean untouched) {

  /** Longest time limit [s]. Decided: a day. */
  public static final double LONGEST = 86_400;

  /** Nothing is asked for. */
  public static final Challenge NONE =
      new Challenge(List.of(), false, OptionalDouble.empty(), false);

  public Challenge {
    goals = List.copyOf(goals);
    double limit = timeLimit.orElse(LONGEST);
    if (!(limit > 0 && limit <= LONGEST)) {
      throw new IllegalArgumentException(
          "timeLimit is " + limit + " s, but must be above 0 and at most " + LONGEST);
    }
  }

  /** The same rules with other goals. */
  public Challenge withGoals(List<Goal> newGoals) {
    return new Challenge(newGoals, inOrder, timeLimit, untouched);
  }

  /** The same goals, which count in their order or not. */
  public Challenge withInOrder(boolean newInOrder) {
    return new Challenge(goals, newInOrder, timeLimit, untouched);
  }

  /**
   * The same with another time limit.
   *
   * @param newLimit seconds from the first takeoff on; empty for none
   */
  public Challenge withTimeLimit(OptionalDouble newLimit) {
    return new Challenge(goals, inOrder, newLimit, untouched);
  }

  /** The same for drones that may touch things, or may not. */
  public Challenge withUntouched(boolean newUntouched) {
    return new Challenge(goals, inOrder, timeLimit, newUntouched);
  }
}
