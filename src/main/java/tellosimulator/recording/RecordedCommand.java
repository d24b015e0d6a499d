package tellosimulator.recording;

import java.util.OptionalDouble;

/**
 * A command with what became of it. Immutable; for any thread. Times in simulated seconds since the
 * simulation began.
 *
 * @param drone its number, from 1
 * @param sent when it arrived
 * @param text as it was sent, one character a byte
 * @param outcome what became of it
 * @param answered when the reply was sent; empty without one
 * @param reply as it was sent; empty without one
 * @param reason why it was refused, failed or was ignored, in English words; may be empty
 */
public record RecordedCommand(
    int drone,
    double sent,
    String text,
    Outcome outcome,
    OptionalDouble answered,
    String reply,
    String reason) {

  /** What became of a command. */
  public enum Outcome {
    /** The drone answered that it was carried out, or with a value. */
    ANSWERED,
    /** It needs no reply, as {@code rc}, or none was recorded. */
    UNANSWERED,
    /** The drone refused it before it began. */
    REFUSED,
    /** It began, but came to another end. */
    FAILED,
    /** The drone did not react to it. */
    IGNORED,
    /** It, or its reply, was lost on the way. */
    LOST;

    /** Whether its author wanted something else. */
    public boolean wrong() {
      return this != ANSWERED && this != UNANSWERED;
    }
  }

  /** How long the reply took [s]; empty without one. */
  public OptionalDouble duration() {
    return answered.isPresent()
        ? OptionalDouble.of(Math.max(0, answered.getAsDouble() - sent))
        : OptionalDouble.empty();
  }
}
