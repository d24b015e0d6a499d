package tellosimulator.junit;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.command.WireText;

/**
 * A text that came to a drone, and what became of it until now. Immutable.
 *
 * @param text as it was sent, without line end
 * @param sender address and port
 * @param seconds when it was taken
 * @param outcome what became of it
 * @param replies in the order in which they were given
 * @param explanation why it was not carried out, in plain words; empty if it was
 */
public record JournalEntry(
    String text,
    InetSocketAddress sender,
    double seconds,
    Outcome outcome,
    List<Answer> replies,
    String explanation) {

  /** What became of a text. */
  public enum Outcome {
    /** It was taken; no answer was given yet, or none ever is, as to {@code rc}. */
    TAKEN,
    /** It was answered, and so carried out. */
    ANSWERED,
    /** The drone said that it does not do it. */
    REFUSED,
    /** The drone began it, and said that it came to another end. */
    FAILED,
    /** A fault of the link kept it from the drone. */
    LOST,
    /** The drone does not react to it. */
    IGNORED,
    /** It came from another host than the operator's, and had no effect. */
    TURNED_AWAY
  }

  /**
   * An answer to a text.
   *
   * @param text as on the wire, but for the line end
   * @param delay from when the text was taken to the answer [s]
   */
  public record Answer(String text, double delay) {}

  public JournalEntry {
    replies = List.copyOf(replies);
  }

  /** The last reply; empty if there is none. */
  public String reply() {
    return replies.isEmpty() ? "" : replies.get(replies.size() - 1).text();
  }

  /** Whether nothing more is to be waited for. */
  boolean settled() {
    return outcome != Outcome.TAKEN || WireText.isUnanswered(text);
  }

  /** Whether it is a command, or begins with it: {@code forward} or {@code forward 100}. */
  boolean is(String command) {
    return text.equals(command) || text.startsWith(command + " ");
  }

  /** The same, of which something more is to be said. */
  JournalEntry explained(String newExplanation) {
    return new JournalEntry(text, sender, seconds, outcome, replies, newExplanation);
  }

  JournalEntry answered(Outcome newOutcome, Answer answer, String newExplanation) {
    List<Answer> all = new ArrayList<>(replies);
    all.add(answer);
    return new JournalEntry(text, sender, seconds, newOutcome, all, newExplanation);
  }

  /** A line of the journal. */
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
