package tellosimulator.goal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.words.Phrase;

/**
 * How far drones have come with a {@link Challenge}. Immutable; for any thread.
 *
 * @param challenge what is asked for
 * @param reached for each goal how long after the first takeoff it was reached [s]
 * @param elapsed since the first takeoff, and no further once it is over [s]
 * @param failure why the goals cannot be reached any more; empty unless they cannot
 * @param miss what a drone did since the last goal that almost reached one, and why it does not
 *     count; empty if there is no such thing
 */
public record Progress(
    Challenge challenge,
    List<OptionalDouble> reached,
    double elapsed,
    Optional<Phrase> failure,
    Optional<Phrase> miss) {

  /** Without a near miss. */
  public Progress(
      Challenge challenge, List<OptionalDouble> reached, double elapsed, Optional<Phrase> failure) {
    this(challenge, reached, elapsed, failure, Optional.empty());
  }

  /** How it stands. */
  public enum Status {
    /** Goals are left to be reached. */
    RUNNING,
    /** All goals are reached. */
    REACHED,
    /** Not all goals are reached, and they cannot be any more. */
    FAILED
  }

  public Progress {
    reached = List.copyOf(reached);
  }

  /** Before the first takeoff. */
  public static Progress start(Challenge challenge) {
    List<OptionalDouble> none =
        challenge.goals().stream().map(goal -> OptionalDouble.empty()).toList();
    return new Progress(challenge, none, 0, Optional.empty());
  }

  /** How it stands; a challenge without goals runs for ever. */
  public Status status() {
    if (failure.isPresent()) {
      return Status.FAILED;
    }
    return !reached.isEmpty() && count() == reached.size() ? Status.REACHED : Status.RUNNING;
  }

  /** How many goals are reached. */
  public int count() {
    return (int) reached.stream().filter(OptionalDouble::isPresent).count();
  }

  /** How one stands with a goal, by its index from 0. */
  public GoalState state(int index) {
    if (reached.get(index).isPresent()) {
      return GoalState.DONE;
    }
    boolean turn = !challenge.inOrder() || count() == index;
    return turn && status() == Status.RUNNING ? GoalState.ACTIVE : GoalState.LATER;
  }

  /** The result in a line: {@code goals: 1 of 3 reached after 60.0 s: time is over}. */
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
