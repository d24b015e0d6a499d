package tellosimulator.grade;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;

/**
 * The result of a flight as the simulator reports it. Immutable.
 *
 * @param verdict {@code reached}, {@code failed}, {@code missed}, or {@link #NOT_FLOWN}
 * @param reason why the goals were not reached, as part of a sentence; why there was no flight, as
 *     a sentence
 * @param seconds duration of the flight from the first takeoff [simulated s]
 * @param score the points; empty if the scenario gives none
 * @param commands number of commands that the program sent
 * @param refused number of commands that were answered with an error
 */
public record FlightResult(
    String verdict,
    Optional<String> reason,
    double seconds,
    List<GoalResult> goals,
    Optional<ScoreResult> score,
    int commands,
    int refused,
    int touches,
    int crashes) {

  /** The verdict on a program that was never started. */
  public static final String NOT_FLOWN = "not flown";

  public FlightResult {
    goals = List.copyOf(goals);
  }

  /**
   * A goal.
   *
   * @param task what must be done
   * @param points its points; 0 if it gives none
   * @param reached when it was reached, after the first takeoff [simulated s]; empty if it was not
   * @param drone the drone that must reach it; empty if any may
   */
  public record GoalResult(String task, double points, OptionalDouble reached, OptionalInt drone) {}

  /**
   * The points of a flight.
   *
   * @param of the most points that one can get
   * @param entries the points won and lost, by time
   */
  public record ScoreResult(double points, double of, List<ScoreEntry> entries) {

    public ScoreResult {
      entries = List.copyOf(entries);
    }
  }

  /**
   * Points that were won or lost.
   *
   * @param second when, after the first takeoff [simulated s]
   * @param points negative if they were lost
   */
  public record ScoreEntry(double second, double points, String why) {}

  /** Returns the result of a program that was never started on a course. */
  static FlightResult none(Challenge challenge) {
    List<GoalResult> goals =
        challenge.goals().stream()
            .map(
                goal ->
                    new GoalResult(
                        goal.phrase().english(),
                        goal.terms().points(),
                        OptionalDouble.empty(),
                        OptionalInt.empty()))
            .toList();
    Optional<ScoreResult> score =
        Progress.start(challenge).score().map(start -> new ScoreResult(0, start.of(), List.of()));
    return new FlightResult(NOT_FLOWN, Optional.empty(), 0, goals, score, 0, 0, 0, 0);
  }

  /** Returns a copy with another reason. */
  FlightResult because(Optional<String> other) {
    return new FlightResult(
        verdict, other, seconds, goals, score, commands, refused, touches, crashes);
  }

  /** Returns the number of goals that were reached. */
  public int reached() {
    return (int) goals.stream().filter(goal -> goal.reached().isPresent()).count();
  }

  /** Returns the points; without points in the scenario, one for each goal that was reached. */
  public double points() {
    return score.map(ScoreResult::points).orElse((double) reached());
  }

  /**
   * Returns the most points that one can get; without points in the scenario, one for each goal.
   */
  public double of() {
    return score.map(ScoreResult::of).orElse((double) goals.size());
  }

  /**
   * Reads the file that a simulator writes with {@code --result}.
   *
   * @throws IllegalArgumentException if the text is no such file; the message is one sentence
   */
  static FlightResult read(String json) {
    return JsonRecords.read(FlightResult.class, Json.value(json)); // ignores other members
  }
}
