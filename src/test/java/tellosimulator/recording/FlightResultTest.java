package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Scoring;
import tellosimulator.goal.Terms;
import tellosimulator.json.Json;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.words.Phrase;

class FlightResultTest {

  @TempDir private Path folder;

  private String written(FlightResult result) throws IOException {
    Path file = folder.resolve("result.json");
    result.write(file);
    return Files.readString(file);
  }

  private static FlightResult flown(Challenge challenge, String... commands) {
    GoalWatch watch = new GoalWatch(challenge, news -> {});
    SimulatedDrones drones = new SimulatedDrones(SimConfig.DEFAULT, List.of(watch));
    drones.fly(commands);
    Progress progress = watch.progress();
    return FlightResult.of(progress, false, progress.score(), watch.tally());
  }

  private static Challenge landing(double points, Optional<Scoring> scoring) {
    Goal land =
        new Goal.Land(
            Terms.ANY.worth(points), new GoalRegion(Vec3.ZERO, GoalRegion.DEFAULT_RADIUS));
    return new Challenge(List.of(land), false, OptionalDouble.empty(), false, scoring);
  }

  @Test
  void everythingIsInOneObject() throws IOException {
    Scoring scoring =
        new Scoring(
            Map.of(Infraction.REFUSED, 1.0),
            Optional.empty(),
            Optional.empty(),
            Scoring.Limits.DEFAULT);
    FlightResult result =
        flown(landing(10, Optional.of(scoring)), "command", "takeoff", "up 5000", "land");
    double seconds = Json.rounded(result.seconds());

    assertThat(written(result).replace(Double.toString(seconds), "SECONDS"))
        .isEqualToIgnoringNewLines(
            """
            {
              "verdict": "reached",
              "seconds": SECONDS,
              "goals": [
                {
                  "task": "land at x 0, y 0 cm",
                  "points": 10.0,
                  "reached": SECONDS,
                  "drone": 1
                }
              ],
              "score": {
                "points": 9.0,
                "of": 10.0,
                "entries": [
                  {
                    "second": 2.995,
                    "points": -1.0,
                    "why": "WHY"
                  },
                  {
                    "second": SECONDS,
                    "points": 10.0,
                    "why": "reached goal 1 of 1: land at x 0, y 0 cm"
                  }
                ]
              },
              "commands": 4,
              "refused": 1,
              "touches": 0,
              "crashes": 0
            }
            """
                .replace("WHY", result.score().orElseThrow().entries().get(0).why()));
  }

  @Test
  void whatIsNotThereIsLeftOut() throws IOException {
    FlightResult result = flown(landing(0, Optional.empty()), "command");

    assertThat(written(result))
        .contains("\"verdict\": \"missed\"", "\"seconds\": 0.0")
        .doesNotContain("reason", "reached", "\"drone\"", "score");
  }

  @Test
  void whatIsWrittenIsReadAgain() throws IOException {
    FlightResult result = flown(landing(10, Optional.empty()), "command", "takeoff", "land");

    assertThat(FlightResult.read(written(result))).isEqualTo(result);
  }

  @Test
  void aRunThatEndsTooEarlyIsNoFailure() {
    GoalWatch watch = new GoalWatch(landing(0, Optional.empty()), news -> {});
    Progress ended = watch.progress().failed(Phrase.of("the program has ended"));

    assertThat(FlightResult.of(ended, true, Optional.empty(), watch.tally()).verdict())
        .isEqualTo("missed");
    assertThat(FlightResult.of(ended, false, Optional.empty(), watch.tally()).verdict())
        .isEqualTo("failed");
  }
}
