package tellosimulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.files.AtomicFile;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.goal.Tally;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.words.Phrase;

/**
 * The result of a run of the simulator, which it writes for other programs. Immutable.
 *
 * @param verdict {@code reached}, {@code failed}, {@code missed}, or {@link #NOT_FLOWN}
 * @param reason why the goals were not reached, as part of a sentence
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
   * @param drone the drone that reached it; empty if none did
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

  /**
   * Returns the result of a run, with times as they are written.
   *
   * @param progress the progress when the verdict was final, or at the end
   * @param missed whether the run ended although open goals could still have been reached
   * @param score the final score; empty if the challenge has no points
   */
  public static FlightResult of(
      Progress progress, boolean missed, Optional<Score> score, Tally tally) {
    return new FlightResult(
        verdict(progress.status(), missed),
        progress.failure().map(Phrase::english),
        Json.rounded(progress.elapsed()),
        goals(progress, tally.winners()),
        score.map(FlightResult::result),
        tally.commands(),
        tally.count(Infraction.REFUSED),
        tally.count(Infraction.TOUCH),
        tally.count(Infraction.CRASH));
  }

  /** Returns the result of a program that was never started on a course. */
  public static FlightResult none(Challenge challenge) {
    Progress start = Progress.start(challenge);
    List<OptionalInt> noWinners =
        Collections.nCopies(challenge.goals().size(), OptionalInt.empty());
    return new FlightResult(
        NOT_FLOWN,
        Optional.empty(),
        0,
        goals(start, noWinners),
        start.score().map(score -> new ScoreResult(0, score.of(), List.of())),
        0,
        0,
        0,
        0);
  }

  private static String verdict(Progress.Status status, boolean missed) {
    return switch (status) {
      case REACHED -> "reached";
      case FAILED -> missed ? "missed" : "failed";
      case RUNNING -> "missed";
    };
  }

  private static List<GoalResult> goals(Progress progress, List<OptionalInt> winners) {
    List<GoalResult> goals = new ArrayList<>();
    for (Goal goal : progress.challenge().goals()) {
      OptionalDouble reached = rounded(progress.reached().get(goals.size()));
      OptionalInt drone = reached.isPresent() ? winners.get(goals.size()) : OptionalInt.empty();
      goals.add(new GoalResult(goal.phrase().english(), goal.terms().points(), reached, drone));
    }
    return goals;
  }

  private static OptionalDouble rounded(OptionalDouble seconds) {
    return seconds.isPresent()
        ? OptionalDouble.of(Json.rounded(seconds.getAsDouble()))
        : OptionalDouble.empty();
  }

  private static ScoreResult result(Score score) {
    List<ScoreEntry> entries =
        score.entries().stream()
            .map(
                each ->
                    new ScoreEntry(
                        Json.rounded(each.second()), each.points(), each.why().english()))
            .toList();
    return new ScoreResult(score.points(), score.of(), entries);
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
   * Writes the result as a JSON file.
   *
   * @throws IOException if the file cannot be written; an existing file is then unchanged
   */
  public void write(Path file) throws IOException {
    String text = Json.lines(JsonRecords.write(FlightResult.class, this)) + "\n";
    AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /**
   * Reads the file that {@link #write} writes.
   *
   * @throws IllegalArgumentException if the text is no such file; the message is one sentence
   */
  public static FlightResult read(String json) {
    return JsonRecords.read(FlightResult.class, Json.value(json));
  }
}
