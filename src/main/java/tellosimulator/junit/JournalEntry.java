package tellosimulator.junit;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.command.WireText;

/**
 * A text that was sent to a drone, and its outcome so far. Immutable.
 *
 * @param text the text as sent, without its line end
 * @param sender the sender's address and port
 * @param seconds the simulated time at which the text arrived [s]
 * @param outcome the outcome so far
 * @param replies the replies, in the order in which they were sent
 * @param explanation the reason why the drone did not carry out the command, or why its reply was
 *     lost, in plain words; empty if there is none
 */
public record JournalEntry(
    String text,
    InetSocketAddress sender,
    double seconds,
    Outcome outcome,
    List<Answer> replies,
    String explanation) {

  /** The outcome of a text. */
  public enum Outcome {
    /**
     * The drone accepted the text but has not replied yet, or never replies, as with {@code rc}.
     */
    TAKEN,
    /** The drone carried out the command and replied. */
    ANSWERED,
    /** The drone refused the command in its reply. */
    REFUSED,
    /** The drone began the command, and replied that it could not complete it. */
    FAILED,
    /** The text never reached the drone, because of a fault of the link. */
    LOST,
    /** The drone does not react to the text. */
    IGNORED,
    /** The text came from a host other than the operator's, and had no effect. */
    TURNED_AWAY
  }

  /**
   * A reply to a text.
   *
   * @param text the reply as on the wire, without the line end
   * @param delay the time from receiving the text to the reply [s]
   */
  public record Answer(String text, double delay) {}

  public JournalEntry {
    replies = List.copyOf(replies);
  }

  /** Returns the last reply, or an empty text if there is none. */
  public String reply() {
    return replies.isEmpty() ? "" : replies.get(replies.size() - 1).text();
  }

  /** Whether the outcome is final. */
  boolean settled() {
    return outcome != Outcome.TAKEN || WireText.isUnanswered(text);
  }

  /**
   * Returns whether the text begins with the given words: both {@code forward} and {@code forward
   * 100} match {@code forward 100}.
   */
  boolean is(String command) {
    return text.equals(command) || text.startsWith(command + " ");
  }

  /** Returns a copy of this entry with another explanation. */
  JournalEntry explained(String newExplanation) {
    return new JournalEntry(text, sender, seconds, outcome, replies, newExplanation);
  }

  JournalEntry answered(Outcome newOutcome, Answer answer, String newExplanation) {
    List<Answer> all = new ArrayList<>(replies);
    all.add(answer);
    return new JournalEntry(text, sender, seconds, newOutcome, all, newExplanation);
  }

  /** Returns the entry as a line of the journal. */
  @Override
  public String toString() {
    StringBuilder line = new StringBuilder();
    line.append(String.format(Locale.ROOT, "%9.3f s  `%s`", seconds, WireText.printable(text)));
    for (Answer answer : replies) {
      line.append(
          String.format(
              Locale.ROOT,
              " → `%s` after %.3f s",
              WireText.printable(answer.text()),
              answer.delay()));
    }
    if (replies.isEmpty()) {
      line.append(
          switch (outcome) {
            case LOST -> " lost";
            case IGNORED -> " ignored";
            case TURNED_AWAY -> " turned away";
            default -> settled() ? "" : " not answered yet";
          });
    }
    return explanation.isEmpty() ? line.toString() : line + ": " + explanation;
  }
}
