package tellosimulator.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.GoalResult;
import tellosimulator.recording.FlightResult.ScoreEntry;
import tellosimulator.recording.FlightResult.ScoreResult;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Take;

/**
 * The grades of a class of three: Anna reached all goals, Bob has a hostile name and crashed, Eve's
 * program was never started.
 */
final class GradesFixture {

  static final String HOSTILE = "Bob <img src=x onerror=alert(1)>";

  private GradesFixture() {}

  /** Writes recordings and outputs into a folder, and returns the grades. */
  static Grades in(Path folder) throws IOException {
    return new Grades(
        "Gates & <b>rings</b>",
        Take.BEST,
        new Scale(true, 1, 6, 60),
        List.of(
            handIn("Anna", "Anna_17_assignsubmission_file_", 30, flight(reached(), "ended")),
            handIn(
                HOSTILE,
                "Bob_18_assignsubmission_file",
                10,
                recorded(folder, flight(failed(), "exit 1"))),
            handIn("Eve", "eve.py", 0, flight(notFlown(), "no entry file"))));
  }

  private static GradedHandIn handIn(
      String name, String original, double points, GradedFlight flight) {
    double percent = points * 100 / 30;
    String folder = name.replaceAll("[^A-Za-z]+", "-");
    return new GradedHandIn(
        name,
        "",
        "A",
        folder,
        original,
        "fly.py",
        points,
        30,
        Math.round(percent * 100) / 100.0,
        1 + percent / 20,
        percent >= 60,
        List.of(flight));
  }

  private static GradedFlight flight(FlightResult result, String program) {
    return new GradedFlight("slalom", 7, 1, result, program, "max", 1.5, "");
  }

  private static GradedFlight recorded(Path folder, GradedFlight flight) {
    String where = "recordings/Bob-img-src-x-onerror-alert-/" + flight.name();
    try {
      Files.createDirectories(folder.resolve(where));
      RecordingFixture.in(folder.resolve(where).resolve("flight"));
      Files.writeString(
          folder.resolve(where).resolve(GradedFlight.OUTPUT),
          "x".repeat(5000) + "\nTraceback\n\u001b[31m" + RecordingFixture.MARKUP + "\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return new GradedFlight(
        flight.course(),
        flight.seed(),
        flight.attempt(),
        flight.result(),
        flight.program(),
        flight.time(),
        flight.wallSeconds(),
        where + "/flight");
  }

  private static FlightResult reached() {
    return result(
        "reached",
        Optional.empty(),
        OptionalDouble.of(12.5),
        30,
        new ScoreEntry(8, 20, "reached goal 1 of 2: reach the ring"),
        new ScoreEntry(12.5, 10, "reached goal 2 of 2: land"));
  }

  private static FlightResult failed() {
    return result(
        "failed",
        Optional.of("drone 1 crashed into </p><script>x</script>\u0001"),
        OptionalDouble.empty(),
        10,
        new ScoreEntry(8, 20, "reached goal 1 of 2: reach the ring"),
        new ScoreEntry(9, -10, "drone 1 crashed into <pole> & \"]]>\uFFFE"));
  }

  private static FlightResult result(
      String verdict,
      Optional<String> reason,
      OptionalDouble landed,
      double points,
      ScoreEntry... entries) {
    return new FlightResult(
        verdict,
        reason,
        12.5,
        goals(OptionalDouble.of(8), landed),
        Optional.of(new ScoreResult(points, 30, List.of(entries))),
        7,
        1,
        2,
        verdict.equals("failed") ? 1 : 0);
  }

  private static List<GoalResult> goals(OptionalDouble first, OptionalDouble second) {
    return List.of(
        new GoalResult("reach x 0, y 50, z 80 cm", 20, first, OptionalInt.empty()),
        new GoalResult("land", 10, second, OptionalInt.empty()));
  }

  private static FlightResult notFlown() {
    return new FlightResult(
        FlightResult.NOT_FLOWN,
        Optional.empty(),
        0,
        goals(OptionalDouble.empty(), OptionalDouble.empty()),
        Optional.of(new ScoreResult(0, 30, List.of())),
        0,
        0,
        0,
        0);
  }
}
