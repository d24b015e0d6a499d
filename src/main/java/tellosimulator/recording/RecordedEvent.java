package tellosimulator.recording;

import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.math.Vec3;

/**
 * A line of {@code events.jsonl}. Immutable; for any thread.
 *
 * @param time simulated seconds since the simulation began
 * @param drone its number, from 1; empty if it concerns all
 * @param kind {@code took-off}, {@code refused} and so on; may be one that this version does not
 *     know
 * @param severity {@code detail}, {@code information}, {@code warning} or {@code error}
 * @param text in English words
 * @param about the command that it concerns
 * @param place of the drone then, room frame [m]
 */
public record RecordedEvent(
    double time,
    OptionalInt drone,
    String kind,
    String severity,
    String text,
    About about,
    Optional<Vec3> place) {

  /**
   * What an event says of a command; each text is empty where it does not apply.
   *
   * @param reason why it was refused, or failed, in English words
   */
  public record About(String command, String reply, String reason) {}

  static RecordedEvent of(Fields fields) {
    return new RecordedEvent(
        fields.moment("t").orElse(0),
        fields.whole("drone"),
        fields.text("kind"),
        fields.text("severity"),
        fields.text("text"),
        new About(fields.text("command"), fields.text("reply"), fields.text("reason")),
        fields.place());
  }
}
