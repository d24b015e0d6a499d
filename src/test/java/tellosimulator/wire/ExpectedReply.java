package tellosimulator.wire;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A reply that must come.
 *
 * @param text what it says, or a regular expression between slashes
 * @param when at once, when the motion is over, or within a span of time
 * @param to the name of the client that gets it; empty for the one that asked
 */
record ExpectedReply(ExpectedText text, When when, String to) {

  private static final Pattern NOTATION =
      Pattern.compile(
          "(?<text>.*?) @(?<when>now|late|(?<least>[0-9.]+)\\.\\.(?<most>[0-9.]+))"
              + "( to (?<to>\\w+))?");

  /** Motion takes at least this long [s]. */
  private static final double SHORTEST_MOTION = 0.5;

  private static final double LONGEST_MOTION = 25;

  /**
   * The span of time in which it must come.
   *
   * @param word as in the table
   * @param least after the command [s]
   * @param most after the command [s]
   */
  record When(String word, double least, double most) {

    boolean atOnce() {
      return word.equals("now");
    }

    /** Whether the drone must stand still when it comes. */
    boolean whenMotionIsOver() {
      return word.equals("late");
    }
  }

  static ExpectedReply of(String place, String part) {
    Matcher matcher = NOTATION.matcher(part);
    if (!matcher.matches()) {
      throw new IllegalArgumentException(
          place + ": expected `TEXT @now`, `TEXT @late` or `TEXT @1..2`, found `" + part + "`");
    }
    String to = matcher.group("to");
    return new ExpectedReply(
        ExpectedText.of(matcher.group("text")), when(matcher), to == null ? "" : to);
  }

  private static When when(Matcher matcher) {
    String word = matcher.group("when");
    return switch (word) {
      case "now" -> new When(word, 0, 0);
      case "late" -> new When(word, SHORTEST_MOTION, LONGEST_MOTION);
      default ->
          new When(
              word,
              Double.parseDouble(matcher.group("least")),
              Double.parseDouble(matcher.group("most")));
    };
  }
}
