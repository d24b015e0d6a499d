package tellosimulator.goal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import tellosimulator.words.Phrase;

/**
 * The drones' progress in a {@link Challenge}. Immutable.
 *
 * @param challenge the challenge
 * @param reached for each goal, the time at which it was reached, counted from the first takeoff
 *     [s]; empty if it has not been reached
 * @param elapsed the time since the first takeoff [s]; stops when the challenge is over
 * @param failure the reason why the goals can no longer be reached; empty unless the challenge
 *     failed
 * @param miss the latest near miss since a goal was last reached, with the reason why it does not
 *     count; empty if there is none
 * @param score the points; empty if the challenge has none. Can still change after the verdict,
 *     until all drones are on the ground
 */
public record Progress(
    Challenge challenge,
    List<OptionalDouble> reached,
    double elapsed,
    Optional<Phrase> failure,
    Optional<Phrase> miss,
    Optional<Score> score) {

  /** Creates progress without a near miss and without points. */
  public Progress(
      Challenge challenge, List<OptionalDouble> reached, double elapsed, Optional<Phrase> failure) {
    this(challenge, reached, elapsed, failure, Optional.empty(), Optional.empty());
  }

  /** The status of a challenge. */
  public enum Status {
    /** Some goals still have to be reached. */
    RUNNING,
    /** All goals have been reached. */
    REACHED,
    /** The challenge has failed: some goals have not been reached, and can no longer be reached. */
    FAILED
  }

  public Progress {
    reached = List.copyOf(reached);
  }

  /** Returns the progress at the start, before the first takeoff. */
  public static Progress start(Challenge challenge) {
    List<OptionalDouble> none =
        challenge.goals().stream().map(goal -> OptionalDouble.empty()).toList();
    return new Progress(challenge, none, 0, Optional.empty())
        .withScore(
            challenge.scored() ? Optional.of(Score.of(challenge, List.of())) : Optional.empty());
  }

  /** Returns a copy with another near miss. */
  Progress withMiss(Phrase newMiss) {
    return new Progress(challenge, reached, elapsed, failure, Optional.of(newMiss), score);
  }

  /** Returns a copy that has failed. */
  public Progress failed(Phrase reason) {
    return new Progress(challenge, reached, elapsed, Optional.of(reason), miss, score);
  }

  /** Returns a copy with another score. */
  Progress withScore(Optional<Score> newScore) {
    return newScore.equals(score)
        ? this // so that listeners notice at once that nothing has changed
        : new Progress(challenge, reached, elapsed, failure, miss, newScore);
  }

  /** Returns the entries of the score other than those of reached goals. */
  public List<Score.Entry> penaltiesAndBonus() {
    long goals =
        IntStream.range(0, reached.size())
            .filter(i -> reached.get(i).isPresent())
            .filter(i -> challenge.goals().get(i).terms().points() > 0)
            .count();
    List<Score.Entry> others = new ArrayList<>();
    for (Score.Entry entry : score.map(Score::entries).orElse(List.of())) {
      goals -= entry.points() > 0 ? 1 : 0; // the bonus comes after all goals
      if (entry.points() < 0 || goals < 0) {
        others.add(entry);
      }
    }
    return others;
  }

  /** Returns the status. A challenge without goals runs forever. */
  public Status status() {
    if (failure.isPresent()) {
      return Status.FAILED;
    }
    return !reached.isEmpty() && count() == reached.size() ? Status.REACHED : Status.RUNNING;
  }

  /** Returns the number of reached goals. */
  public int count() {
    return (int) reached.stream().filter(OptionalDouble::isPresent).count();
  }

  /** Returns the state of a goal, by its index from 0. */
  public GoalState state(int index) {
    if (reached.get(index).isPresent()) {
      return GoalState.DONE;
    }
    boolean turn = !challenge.inOrder() || count() == index;
    return turn && status() == Status.RUNNING ? GoalState.ACTIVE : GoalState.LATER;
  }

  /**
   * Describes the result in one line, such as {@code goals: 1 of 3 reached after 60.0 s: time is
   * over}.
   */
  public Phrase phrase() {
    return failure
        .map(
            reason ->
                Phrase.of(
                    "goals: %d of %d reached after %.1f s: %s",
                    count(), reached.size(), elapsed, reason))
        .orElse(
            Phrase.of("goals: %d of %d reached after %.1f s", count(), reached.size(), elapsed));
  }
}
