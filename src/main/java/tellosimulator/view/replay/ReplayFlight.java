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
 * A recording that has been read. Immutable.
 *
 * @param name the display name, usually the name of the folder
 * @param folder the folder of the recording
 * @param flight the content of the recording
 * @param snapshots provides the snapshot of each moment
 */
public record ReplayFlight(
    String name, Path folder, RecordedFlight flight, FlightSnapshots snapshots) {

  /**
   * Reads a recording, which may take a while.
   *
   * @param place the recording's folder, or a file in it
   * @throws UnreadableRecordingException if there is no readable recording; the message is a
   *     sentence
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
   * Flies a recording again, as fast as possible: from its inputs if they were recorded, otherwise
   * from its commands.
   *
   * @param folder the folder of the recording
   * @param name the name of the new flight
   * @throws UnreadableRecordingException if there is no readable recording; the message is a
   *     sentence
   * @throws IOException if the recording cannot be flown again; the message is a clause
   */
  static ReplayFlight flyAgain(Path folder, String name)
      throws UnreadableRecordingException, IOException {
    try (TemporaryFolder temporary = TemporaryFolder.create("tello-ghost")) {
      Path again = Replay.of(folder).fly(RecordingFolder.at(temporary.path()));
      ReplayFlight flown = read(again);
      return new ReplayFlight(name, folder, flown.flight, flown.snapshots);
    }
  }

  /** Returns the time of the takeoff, in simulated seconds since the start of the simulation. */
  double takeoff() {
    return flight.run().started();
  }

  /** Returns the first displayed moment [s]. */
  double begin() {
    return flight.shownBegin();
  }

  /** Returns the last displayed moment [s]. */
  double end() {
    return Math.max(begin(), flight.end());
  }

  /**
   * Converts a moment of this flight to the moment of another flight at the same time after takeoff
   * [s].
   *
   * @param time a moment of this flight [s]
   */
  double timeIn(ReplayFlight other, double time) {
    return time - takeoff() + other.takeoff();
  }
}
