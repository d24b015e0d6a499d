package tellosimulator.view.replay;

import java.nio.file.Files;
import java.nio.file.Path;
import tellosimulator.recording.FlightSnapshots;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.UnreadableRecordingException;

/**
 * A recording as the player has it. Immutable; for any thread.
 *
 * @param name of its folder
 * @param flight what the folder says
 * @param snapshots what could be seen at its moments
 */
public record ReplayFlight(String name, RecordedFlight flight, FlightSnapshots snapshots) {

  /** How long before the takeoff the player begins at the most [s]. Decided: as reports do. */
  private static final double LONGEST_LEAD = 10;

  /**
   * Reads a recording, which may take a while.
   *
   * @param place its folder, or a file in it
   * @throws UnreadableRecordingException with a sentence, if there is none
   */
  public static ReplayFlight read(Path place) throws UnreadableRecordingException {
    Path absolute = place.toAbsolutePath().normalize();
    Path folder = Files.isRegularFile(absolute) ? absolute.getParent() : absolute;
    RecordedFlight flight = RecordedFlight.read(folder);
    Path name = folder.getFileName();
    return new ReplayFlight(
        name == null ? folder.toString() : name.toString(), flight, new FlightSnapshots(flight));
  }

  /** The takeoff, in simulated seconds since the simulation began. */
  double takeoff() {
    return flight.run().started();
  }

  /** The first moment that is shown [s]. */
  double begin() {
    return Math.max(flight.begin(), takeoff() - LONGEST_LEAD);
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
