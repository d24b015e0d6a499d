package tellosimulator.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.replay.Replay;

/**
 * Computes the result of a flight again, by flying its recording again. Works on the calling
 * thread.
 */
final class Regrading {

  private Regrading() {}

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
    FlightResult before = flight.result();
    FlightResult after = judged(folder.resolve(flight.recording()), scratch);
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

  /**
   * Returns the result that a recording gives.
   *
   * @param scratch a temporary folder
   * @throws IOException if the recording cannot be read; the message is a clause
   */
  static FlightResult judged(Path recording, Path scratch) throws IOException {
    try {
      Path into = Files.createTempDirectory(scratch, "flight");
      return Replay.of(recording).judge(RecordingFolder.at(into));
    } catch (UnreadableRecordingException e) {
      throw new IOException(e.getMessage().replaceFirst("\\.$", ""), e);
    }
  }
}
