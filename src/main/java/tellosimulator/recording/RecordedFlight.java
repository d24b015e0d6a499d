package tellosimulator.recording;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import tellosimulator.scenario.Scenario;
import tellosimulator.words.Phrase;

/**
 * A recording, as far as it can be read. Immutable; for any thread.
 *
 * @param run what is known of it as a whole
 * @param tracks how the drones moved, in the order of their numbers
 * @param commands with their replies, in the order in which they came
 * @param events in the order in which they happened
 * @param goals of the scenario
 * @param scenario as it was flown; empty if it was not kept, or cannot be read
 * @param remarks what is missing, in one clause each
 */
public record RecordedFlight(
    RecordedRun run,
    List<Track> tracks,
    List<RecordedCommand> commands,
    List<RecordedEvent> events,
    List<RecordedGoal> goals,
    Optional<Scenario> scenario,
    List<Phrase> remarks) {

  /** How long before the takeoff a flight is shown at the most [s]. Decided. */
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
   * @param folder in which it is
   * @throws UnreadableRecordingException with a sentence, if there is none
   */
  public static RecordedFlight read(Path folder) throws UnreadableRecordingException {
    return new RecordingReader(folder).read();
  }

  /**
   * Reads what is known of a recording as a whole, however long it is: nothing but {@link #run},
   * {@link #scenario} and {@link #remarks}.
   *
   * @param folder in which it is
   * @throws UnreadableRecordingException with a sentence, if there is none
   */
  public static RecordedFlight readOutline(Path folder) throws UnreadableRecordingException {
    return new RecordingReader(folder).readOutline();
  }

  /** The first moment that is shown to people: that of a long wait for a takeoff is not [s]. */
  public double shownBegin() {
    return Math.max(begin(), run.started() - LONGEST_LEAD);
  }

  /** The first moment that it tells of [s]. */
  double begin() {
    double samples =
        tracks.stream()
            .mapToDouble(track -> track.samples().get(0).time())
            .min()
            .orElse(run.started());
    double sent = commands.isEmpty() ? samples : commands.get(0).sent();
    return Math.min(run.started(), Math.min(samples, sent));
  }

  /** The last moment that it tells of [s]. */
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
