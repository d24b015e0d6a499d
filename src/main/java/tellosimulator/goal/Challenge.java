package tellosimulator.goal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A list of goals with their rules. A crash always fails the challenge. Immutable.
 *
 * @param goals the goals
 * @param inOrder whether the goals must be reached in their order, at most one per step
 * @param timeLimit the time limit, counted from the first takeoff [s]; empty for none
 * @param untouched whether the challenge fails when a drone touches anything in flight
 * @param scoring how points are lost, and won other than by goals; empty for no such points
 */
public record Challenge(
    List<Goal> goals,
    boolean inOrder,
    OptionalDouble timeLimit,
    boolean untouched,
    Optional<Scoring> scoring) {

  /** Maximum time limit [s]. Decided: one day. */
  public static final double LONGEST = 86_400;

  /** A challenge without goals. */
  public static final Challenge NONE =
      new Challenge(List.of(), false, OptionalDouble.empty(), false);

  /** Creates a challenge without {@link #scoring}. */
  public Challenge(List<Goal> goals, boolean inOrder, OptionalDouble timeLimit, boolean untouched) {
    this(goals, inOrder, timeLimit, untouched, Optional.empty());
  }

  public Challenge {
    goals = List.copyOf(goals);
    double limit = timeLimit.orElse(LONGEST);
    if (!(limit > 0 && limit <= LONGEST)) {
      throw new IllegalArgumentException(
          "timeLimit is " + limit + " s, but must be above 0 and at most " + LONGEST);
    }
  }

  /** Returns a copy with other goals. */
  public Challenge withGoals(List<Goal> newGoals) {
    return new Challenge(newGoals, inOrder, timeLimit, untouched, scoring);
  }

  /** Returns a copy whose goals must be reached in order, or may be reached in any order. */
  public Challenge withInOrder(boolean newInOrder) {
    return new Challenge(goals, newInOrder, timeLimit, untouched, scoring);
  }

  /**
   * Returns a copy with another time limit.
   *
   * @param newLimit the time limit, counted from the first takeoff [s]; empty for none
   */
  public Challenge withTimeLimit(OptionalDouble newLimit) {
    return new Challenge(goals, inOrder, newLimit, untouched, scoring);
  }

  /** Returns a copy that fails, or does not fail, when a drone touches anything in flight. */
  public Challenge withUntouched(boolean newUntouched) {
    return new Challenge(goals, inOrder, timeLimit, newUntouched, scoring);
  }

  /** Returns a copy with another way of scoring. */
  public Challenge withScoring(Optional<Scoring> newScoring) {
    return new Challenge(goals, inOrder, timeLimit, untouched, newScoring);
  }

  /** Whether attempts have a score: there are goals, with points or with {@link #scoring}. */
  public boolean scored() {
    boolean worth = goals.stream().anyMatch(goal -> goal.terms().points() > 0);
    return worth || (scoring.isPresent() && !goals.isEmpty());
  }
}
