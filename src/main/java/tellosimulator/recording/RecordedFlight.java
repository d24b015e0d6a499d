package tellosimulator.recording;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import tellosimulator.scenario.Scenario;
import tellosimulator.words.Phrase;

/**
 * The readable contents of a recording. Immutable.
 *
 * @param run the general data of the flight
 * @param tracks the motion of the drones, in order of their numbers; thinned out for long flights
 * @param commands the commands with their replies, in order of arrival
 * @param events the events in order, except events that only report the arrival or outcome of a
 *     command
 * @param goals the goals of the scenario
 * @param scenario the scenario as it was flown; empty if it was not recorded or cannot be read
 * @param remarks a clause about each part that is missing
 */
public record RecordedFlight(
    RecordedRun run,
    List<Track> tracks,
    List<RecordedCommand> commands,
    List<RecordedEvent> events,
    List<RecordedGoal> goals,
    Optional<Scenario> scenario,
    List<Phrase> remarks) {

  /** Maximum time from the beginning of the shown part to the takeoff [s]. Decided. */
  private static final double LONGEST_LEAD = 10;

  public RecordedFlight {
    tracks = List.copyOf(tracks);
    commands = List.copyOf(commands);
    events = List.copyOf(events);
    goals = List.copyOf(goals);
    remarks = List.copyOf(remarks);
  }

  /**
   * Reads a recording.
   *
   * @param folder the recording's folder
   * @throws UnreadableRecordingException if the folder contains no readable recording; the message
   *     is one sentence
   */
  public static RecordedFlight read(Path folder) throws UnreadableRecordingException {
    return new RecordingReader(folder).read();
  }

  /**
   * Reads a recording without its {@link #tracks}.
   *
   * @param folder the recording's folder
   * @throws UnreadableRecordingException if the folder contains no readable recording; the message
   *     is one sentence
   */
  public static RecordedFlight readCommands(Path folder) throws UnreadableRecordingException {
    return new RecordingReader(folder).readCommands();
  }

  /**
   * Reads only {@link #run}, {@link #scenario} and {@link #remarks}, so that reading a long
   * recording takes no longer than reading a short one.
   *
   * @param folder the recording's folder
   * @throws UnreadableRecordingException if the folder contains no readable recording; the message
   *     is one sentence
   */
  public static RecordedFlight readOutline(Path folder) throws UnreadableRecordingException {
    return new RecordingReader(folder).readOutline();
  }

  /**
   * The time at which the part shown to users begins [s]; a long wait before the takeoff is left
   * out.
   */
  public double shownBegin() {
    return Math.max(begin(), run.started() - LONGEST_LEAD);
  }

  /** The earliest time in the recording [s]. */
  double begin() {
    double samples =
        tracks.stream()
            .mapToDouble(track -> track.samples().get(0).time())
            .min()
            .orElse(run.started());
    double sent = commands.isEmpty() ? samples : commands.get(0).sent();
    return Math.min(run.started(), Math.min(samples, sent));
  }

  /** The latest time in the recording [s]. */
  public double end() {
    double samples =
        tracks.stream()
            .mapToDouble(track -> track.samples().get(track.samples().size() - 1).time())
            .max()
            .orElse(run.started());
    double events = this.events.isEmpty() ? samples : lastEvent();
    return Math.max(run.ended().orElse(samples), Math.max(samples, events));
  }

  private double lastEvent() {
    return events.get(events.size() - 1).time();
  }
}
