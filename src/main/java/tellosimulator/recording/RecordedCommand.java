package tellosimulator.recording;

import java.util.OptionalDouble;
import tellosimulator.command.WireText;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.words.Phrase;

/**
 * A command and its outcome. Immutable. Times are simulated seconds since the simulation began.
 *
 * @param drone the drone's number, from 1
 * @param sent the time when the command arrived
 * @param text the text as it was sent, one character for each byte
 * @param outcome the outcome of the command
 * @param answered the time when the reply was sent; empty without a reply
 * @param reply the reply as it was sent; empty without a reply
 * @param reason why the command was refused, failed or ignored; may be empty
 */
public record RecordedCommand(
    int drone,
    double sent,
    String text,
    Outcome outcome,
    OptionalDouble answered,
    String reply,
    Phrase reason) {

  /** The outcome of a command. */
  public enum Outcome {
    /** The drone reported success, or replied with a value. */
    ANSWERED,
    /** The command needs no reply (for example {@code rc}), or no reply was recorded. */
    UNANSWERED,
    /** The drone refused the command before it began. */
    REFUSED,
    /** The command began, but did not succeed. */
    FAILED,
    /** The drone did not react to the command. */
    IGNORED,
    /** The command or its reply was lost in transit. */
    LOST;

    /** Whether the operator probably did not intend this outcome. */
    public boolean wrong() {
      return this != ANSWERED && this != UNANSWERED;
    }
  }

  /** Returns the text; for a packet of the app's protocol, its words. */
  public String words() {
    return NamedPacket.text(WireText.encode(text));
  }

  /** Returns a copy of this command with the given outcome. */
  RecordedCommand ended(
      Outcome newOutcome, OptionalDouble newAnswered, String newReply, Phrase newReason) {
    return new RecordedCommand(drone, sent, text, newOutcome, newAnswered, newReply, newReason);
  }

  /** The time between the command and its reply [s]; empty without a reply. */
  public OptionalDouble duration() {
    return answered.isPresent()
        ? OptionalDouble.of(Math.max(0, answered.getAsDouble() - sent))
        : OptionalDouble.empty();
  }
}
