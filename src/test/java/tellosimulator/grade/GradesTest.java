package tellosimulator.grade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.GoalResult;
import tellosimulator.recording.FlightResult.ScoreEntry;
import tellosimulator.recording.FlightResult.ScoreResult;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Take;

/** Writes and reads grades, and computes them from flights. */
class GradesTest {

  private static final Scale RANGE = new Scale(true, 4, 6, 50);

  @TempDir private Path folder;

  private static GradedFlight flight(String course, int attempt, double points) {
    FlightResult result =
        new FlightResult(
            "missed",
            Optional.of("time is over"),
            12.5,
            List.of(new GoalResult("land", 10, OptionalDouble.of(3.25), OptionalInt.of(1))),
            Optional.of(
                new ScoreResult(points, 40, List.of(new ScoreEntry(3.25, points, "reached")))),
            7,
            1,
            2,
            0);
    return new GradedFlight(course, 3, attempt, result, "exit 1", "max", 4.2, "recordings/a/x");
  }

  private static GradedHandIn handIn(String name, Take take, GradedFlight... flights) {
    HandIn handIn = new HandIn(name, "7", "B", name, name, Path.of(""), "fly.py", Optional.empty());
    return GradedHandIn.of(handIn, List.of(flights), take, RANGE);
  }

  @Test
  void theAttemptThatCountsIsTaken() {
    GradedFlight[] flights = {flight("a", 1, 30), flight("a", 2, 10), flight("b", 1, 20)};

    // best: 30 + 20 of 80; mean: 20 + 20; last: 10 + 20
    assertThat(handIn("Ann", Take.BEST, flights).points()).isEqualTo(50);
    assertThat(handIn("Ann", Take.MEAN, flights).points()).isEqualTo(40);
    assertThat(handIn("Ann", Take.LAST, flights).points()).isEqualTo(30);
    assertThat(handIn("Ann", Take.BEST, flights).of()).isEqualTo(80);
  }

  @Test
  void pointsBecomeAGrade() {
    GradedHandIn half = handIn("Ann", Take.BEST, flight("a", 1, 20));
    GradedHandIn less = handIn("Bob", Take.BEST, flight("a", 1, 19));

    assertThat(half.percent()).isEqualTo(50);
    assertThat(half.grade()).isEqualTo(5); // halfway from 4 to 6
    assertThat(half.passed()).isTrue();
    assertThat(less.grade()).isEqualTo(4.95); // 4 + 0.475 * 2
    assertThat(less.passed()).isFalse();
  }

  @Test
  void whatWasWrittenIsRead() throws IOException {
    Grades grades =
        new Grades(
            "Slalom",
            Take.BEST,
            RANGE,
            List.of(handIn("Bob", Take.BEST, flight("a", 1, 2.5)), handIn("Ann", Take.BEST)));
    grades.write(folder);

    assertThat(Grades.read(folder)).isEqualTo(grades);
    assertThat(grades.handIns()).extracting(GradedHandIn::name).containsExactly("Ann", "Bob");
    assertThat(Files.readString(folder.resolve("grades.csv")).lines())
        .endsWith("Bob,7,B,a,3,1,missed,exit 1,1,1,12.5,2,0,1,2.5,40.0,max,4.2,recordings/a/x")
        .hasSize(2);
    assertThat(Files.readString(folder.resolve("totals.csv")).lines())
        .containsExactly(
            "hand-in,id,group,points,of,percent,grade,passed",
            "Ann,7,B,0.0,0.0,0.0,4.0,false",
            "Bob,7,B,2.5,40.0,6.25,4.13,false"); // 4 + 0.0625 * 2 = 4.125
  }

  @Test
  void namesAreNoFormulasAndBreakNoRows() throws IOException {
    String name = "=cmd(\"x\"),\nEve";
    new Grades("S", Take.BEST, RANGE, List.of(handIn(name, Take.BEST))).write(folder);

    assertThat(Files.readString(folder.resolve("totals.csv")))
        .contains("\r\n\"'=cmd(\"\"x\"\"),\nEve\",7,B,");
  }

  @Test
  void otherFilesAreReported() throws IOException {
    Files.writeString(folder.resolve("grades.json"), "{\"assignment\": 3}");

    assertThatThrownBy(() -> Grades.read(folder))
        .isInstanceOf(IOException.class)
        .hasMessage("it contains no grades: assignment is not what is expected here");
  }

  @Test
  void mergedPartsAreOneClass() throws IOException {
    Path one = Files.createDirectories(folder.resolve("1"));
    Path two = Files.createDirectories(folder.resolve("2"));
    Files.createDirectories(two.resolve("recordings/Ann"));
    Files.writeString(two.resolve("recordings/Ann/output.txt"), "hello");
    new Grades("S", Take.BEST, RANGE, List.of(handIn("Bob", Take.BEST))).write(one);
    new Grades("S", Take.BEST, RANGE, List.of(handIn("Ann", Take.BEST))).write(two);
    Path merged = folder.resolve("merged");

    Grades grades = Grading.merge(List.of(one, two), merged);

    assertThat(grades.handIns()).extracting(GradedHandIn::name).containsExactly("Ann", "Bob");
    assertThat(Grades.read(merged)).isEqualTo(grades);
    assertThat(merged.resolve("recordings/Ann/output.txt")).hasContent("hello");
    assertThatThrownBy(() -> Grading.merge(List.of(one, one), merged))
        .isInstanceOf(IOException.class)
        .hasMessage(one + " also contains the hand-in \"Bob\"");
  }

  @Test
  void theResultOfASimulatorIsRead() {
    FlightResult result =
        FlightResult.read(
            """
            {"verdict": "missed", "reason": null, "seconds": 41.2, "seed": 3,
             "goals": [{"task": "land on mission pad 3", "points": 10, "reached": null, "drone": null}],
             "score": {"points": 25.0, "of": 40.0,
               "entries": [{"second": 12.35, "points": 10.0, "why": "reached goal 1"}]},
             "commands": 17, "refused": 1, "touches": 0, "crashes": 0, "took-off": true}
            """);

    assertThat(result.points()).isEqualTo(25);
    assertThat(result.of()).isEqualTo(40);
    assertThat(result.reached()).isZero();
    assertThat(result.reason()).isEmpty();
    assertThat(result.commands()).isEqualTo(17);
  }
}
