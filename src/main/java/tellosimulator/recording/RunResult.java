package tellosimulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.files.AtomicFile;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.goal.Tally;
import tellosimulator.json.Json;
import tellosimulator.words.Phrase;

/**
 * The outcome of a whole run, for programs that read it. Immutable.
 *
 * @param progress the progress when the verdict was final, or at the end
 * @param missed whether the run ended although open goals could still have been reached
 * @param score the final score; empty if the challenge has no points
 * @param seed the seed of the simulation
 */
public record RunResult(
    Progress progress, boolean missed, Optional<Score> score, Tally tally, long seed) {

  /**
   * Writes the result as a JSON file.
   *
   * @throws IOException if the file cannot be written; an existing file is then unchanged
   */
  public void write(Path file) throws IOException {
    byte[] bytes = (Json.lines(members()) + "\n").getBytes(StandardCharsets.UTF_8);
    AtomicFile.write(file, out -> out.write(bytes));
  }

  private Map<String, Object> members() {
    return Json.object(
        "verdict", verdict(),
        "reason", progress.failure().map(Phrase::english).orElse(null),
        "seconds", progress.elapsed(),
        "seed", seed,
        "goals", goals(),
        "score", score.map(RunResult::members).orElse(null),
        "commands", tally.commands(),
        "refused", tally.count(Infraction.REFUSED),
        "touches", tally.count(Infraction.TOUCH),
        "crashes", tally.count(Infraction.CRASH),
        "took-off", tally.tookOff());
  }

  private String verdict() {
    return switch (progress.status()) {
      case REACHED -> "reached";
      case FAILED -> missed ? "missed" : "failed";
      case RUNNING -> "missed";
    };
  }

  private List<Object> goals() {
    List<Object> goals = new ArrayList<>();
    for (Goal goal : progress.challenge().goals()) {
      OptionalDouble reached = progress.reached().get(goals.size());
      OptionalInt drone = tally.winners().get(goals.size());
      goals.add(
          Json.object(
              "task",
              goal.phrase().english(),
              "points",
              goal.terms().points(),
              "reached",
              reached.isPresent() ? reached.getAsDouble() : null,
              "drone",
              reached.isPresent() && drone.isPresent() ? drone.getAsInt() : null));
    }
    return goals;
  }

  static Map<String, Object> members(Score score) {
    return Json.object(
        "points", score.points(),
        "of", score.of(),
        "entries", score.entries().stream().map(RunResult::members).toList());
  }

  private static Map<String, Object> members(Score.Entry entry) {
    return Json.object(
        "second", entry.second(), "points", entry.points(), "why", entry.why().english());
  }
}
