package tellosimulator.wire;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An expected reply.
 *
 * @param text its content, or a regular expression between slashes
 * @param when at once, when the motion is complete, or within a time span
 * @param to the name of the client that gets it; empty for the sender of the command
 */
record ExpectedReply(ExpectedText text, When when, String to) {

  private static final Pattern NOTATION =
      Pattern.compile(
          "(?<text>.*?) @(?<when>now|late|(?<least>[0-9.]+)\\.\\.(?<most>[0-9.]+))"
              + "( to (?<to>\\w+))?");

  /** Shortest duration of a motion [s]. */
  private static final double SHORTEST_MOTION = 0.5;

  private static final double LONGEST_MOTION = 25;

  /**
   * The time span in which it must arrive.
   *
   * @param word as in the table
   * @param least after the command [s]
   * @param most after the command [s]
   */
  record When(String word, double least, double most) {

    boolean atOnce() {
      return word.equals("now");
    }

    /** Returns whether the drone must stand still when it arrives. */
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
