package tellosimulator.view.replay;

import java.io.IOException;
import java.nio.file.Path;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.recording.FlightSnapshots;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFile;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.replay.Replay;

/**
 * A recording as the player has it. Immutable; for any thread.
 *
 * @param name of its folder, or what else it is called
 * @param folder in which it is
 * @param flight what the folder says
 * @param snapshots what could be seen at its moments
 */
public record ReplayFlight(
    String name, Path folder, RecordedFlight flight, FlightSnapshots snapshots) {

  /**
   * Reads a recording, which may take a while.
   *
   * @param place its folder, or a file in it
   * @throws UnreadableRecordingException with a sentence, if there is none
   */
  public static ReplayFlight read(Path place) throws UnreadableRecordingException {
    Path absolute = place.toAbsolutePath().normalize();
    Path folder = RecordingFile.folderOf(absolute);
    RecordedFlight flight = RecordedFlight.read(folder);
    Path name = folder.getFileName();
    return new ReplayFlight(
        name == null ? folder.toString() : name.toString(),
        folder,
        flight,
        new FlightSnapshots(flight));
  }

  /**
   * Flies a recording again by its inputs, or else by its commands, as fast as this machine can.
   *
   * @param folder of the recording
   * @param name of what comes of it
   * @throws UnreadableRecordingException with a sentence, if there is none
   * @throws IOException with a clause, if it cannot be flown again
   */
  static ReplayFlight flyAgain(Path folder, String name)
      throws UnreadableRecordingException, IOException {
    try (TemporaryFolder temporary = TemporaryFolder.create("tello-ghost")) {
      Path again = Replay.of(folder).fly(RecordingFolder.at(temporary.path()));
      ReplayFlight flown = read(again);
      return new ReplayFlight(name, folder, flown.flight, flown.snapshots);
    }
  }

  /** The takeoff, in simulated seconds since the simulation began. */
  double takeoff() {
    return flight.run().started();
  }

  /** The first moment that is shown [s]. */
  double begin() {
    return flight.shownBegin();
  }

  /** The last moment that is shown [s]. */
  double end() {
    return Math.max(begin(), flight.end());
  }

  /**
   * The same moment after the takeoff, in another flight [s].
   *
   * @param time in this one [s]
   */
  double timeIn(ReplayFlight other, double time) {
    return time - takeoff() + other.takeoff();
  }
}
