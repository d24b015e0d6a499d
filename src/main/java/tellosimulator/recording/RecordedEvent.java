package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/**
 * A line of {@code events.jsonl}. Immutable.
 *
 * @param time simulated seconds since the simulation began
 * @param drone the drone's number, from 1; empty if the event concerns all drones
 * @param kind {@code took-off}, {@code refused} and so on; may be a kind that this version does not
 *     know
 * @param severity {@code detail}, {@code information}, {@code warning} or {@code error}
 * @param phrase the description of the event
 * @param about the command that the event concerns
 * @param place the drone's position at that time, in the room frame [m]
 */
public record RecordedEvent(
    double time,
    OptionalInt drone,
    String kind,
    String severity,
    Phrase phrase,
    About about,
    Optional<Vec3> place) {

  /**
   * The command that an event concerns; texts that do not apply are empty.
   *
   * @param number the command's number in order of arrival, from 1; empty if the command never
   *     arrived
   * @param reason why the command was refused or failed
   */
  public record About(String command, OptionalInt number, String reply, Phrase reason) {}

  /** Kinds of events that are shown as part of their command. */
  private static final Set<String> OF_COMMANDS =
      Set.of("command", "reply", "refused", "failed", "ignored");

  /**
   * Passes all events of a recording to a sink one at a time, because they may not fit into memory.
   * Damaged lines are skipped.
   *
   * @param folder the folder of a recording; it may contain no events
   * @throws IOException if the events cannot be read
   */
  public static void readAll(Path folder, LineReader.Sink<RecordedEvent> sink) throws IOException {
    LineReader.readAll(RecordingFile.EVENTS.in(folder), line -> sink.accept(of(Fields.of(line))));
  }

  /** Whether the event only reports the arrival or the outcome of a command. */
  boolean isOfCommand() {
    return OF_COMMANDS.contains(kind) || !about.command().isEmpty();
  }

  static RecordedEvent of(Fields fields) {
    return new RecordedEvent(
        fields.moment("t").orElse(0),
        fields.whole("drone"),
        fields.text("kind"),
        fields.text("severity"),
        fields.phrase("said", "text"),
        new About(
            fields.text("command"),
            fields.whole("number"),
            fields.text("reply"),
            fields.phrase("reasonSaid", "reason")),
        fields.place());
  }
}
