package tellosimulator.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.goal.Challenge;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.replay.Replay;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.Assignment.AssignedCourse;
import tellosimulator.scenario.AssignmentFile;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;

/** Grades flights from their recordings, by flying them again. Works on the calling thread. */
public final class Regrading {

  private Regrading() {}

  /**
   * Grades a flight as the only one of a hand-in. Its course may be drawn from any seed.
   *
   * @param recording the folder of the recording, which the folder of the results will be
   * @param assignment the file of the assignment
   * @return empty if the flight was on none of the assignment's courses
   * @throws ScenarioException if the assignment or a course contains errors
   * @throws UnreadableRecordingException if there is no readable recording
   * @throws IOException if the flight cannot be flown again; the message is a clause
   */
  public static Optional<Grades> grade(Path recording, Path assignment)
      throws ScenarioException, UnreadableRecordingException, IOException {
    Assignment read = AssignmentFile.read(assignment);
    RecordedFlight outline = RecordedFlight.readOutline(recording);
    long seed = outline.run().seed().orElse(0L);
    Optional<List<String>> flown =
        outline.scenario().map(Scenario::challenge).map(Regrading::goals);
    for (AssignedCourse course : read.courses()) {
      OpenedScenario drawn = OpenedScenario.named(course.scenario()).drawnFrom(seed);
      if (flown.filter(goals(drawn.scenario().challenge())::equals).isPresent()) {
        String name = SeededCourse.name(course.scenario());
        try (TemporaryFolder scratch = TemporaryFolder.create("tello-grade")) {
          FlightResult result = judged(recording, scratch.path());
          GradedFlight flight = new GradedFlight(name, seed, 1, result, "", "", 0, ".");
          String title = recording.getFileName().toString();
          HandIn handIn = new HandIn(title, "", "", "", title, recording, "", Optional.empty());
          GradedHandIn graded = GradedHandIn.of(handIn, List.of(flight), read.take(), read.scale());
          return Optional.of(new Grades(read.name(), read.take(), read.scale(), List.of(graded)));
        }
      }
    }
    return Optional.empty();
  }

  private static List<String> goals(Challenge challenge) {
    return challenge.goals().stream().map(goal -> goal.phrase().english()).toList();
  }

  private static FlightResult judged(Path recording, Path scratch)
      throws UnreadableRecordingException, IOException {
    Path into = Files.createTempDirectory(scratch, "flight");
    return Replay.of(recording).judge(RecordingFolder.at(into));
  }

  /**
   * Returns a flight with the result that its recording gives; unchanged if it was not recorded.
   * The number of commands is that of the run. So are the verdict, its reason and its time if they
   * are still open at the end of the recording, because they were decided after it.
   *
   * @param folder the folder of the results
   * @param scratch a temporary folder
   * @throws IOException if the recording cannot be read; the message is a clause
   */
  static GradedFlight again(GradedFlight flight, Path folder, Path scratch) throws IOException {
    if (flight.recording().isEmpty()) {
      return flight;
    }
    FlightResult after;
    try {
      after = judged(folder.resolve(flight.recording()), scratch);
    } catch (UnreadableRecordingException e) {
      throw new IOException(e.getMessage().replaceFirst("\\.$", ""), e);
    }
    FlightResult before = flight.result();
    boolean open = after.verdict().equals("missed") && after.reason().isEmpty();
    return flight.with(
        new FlightResult(
            open ? before.verdict() : after.verdict(),
            open ? before.reason() : after.reason(),
            open ? before.seconds() : after.seconds(),
            after.goals(),
            after.score(),
            before.commands(),
            after.refused(),
            after.touches(),
            after.crashes()));
  }
}
