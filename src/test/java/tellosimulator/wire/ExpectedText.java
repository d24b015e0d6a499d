package tellosimulator.wire;

import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An expected text: an exact text, or any match of a pattern.
 *
 * @param pattern matches the whole text
 * @param notation as in the table
 */
record ExpectedText(Pattern pattern, String notation) {

  private static final Pattern REPEATED = Pattern.compile("\\{(.)\\*(\\d+)\\}");
  private static final Pattern ESCAPED = Pattern.compile("\\\\([rn0s]|x([0-9a-f]{2}))");

  /** Parses a text, or a regular expression between slashes. */
  static ExpectedText of(String notation) {
    boolean regular = notation.length() > 1 && notation.startsWith("/") && notation.endsWith("/");
    String expression =
        regular ? notation.substring(1, notation.length() - 1) : Pattern.quote(bytes(notation));
    return new ExpectedText(Pattern.compile(expression, Pattern.DOTALL), notation);
  }

  boolean fits(String text) {
    return pattern.matcher(text).matches();
  }

  /**
   * Replaces the notations of a cell: {@code \r \n \0 \s \xNN} for single bytes, {@code {a*9}} for
   * nine of them.
   */
  static String bytes(String notation) {
    String repeated =
        REPEATED
            .matcher(notation)
            .replaceAll(
                found ->
                    Matcher.quoteReplacement(
                        found.group(1).repeat(Integer.parseInt(found.group(2)))));
    return ESCAPED.matcher(repeated).replaceAll(found -> Matcher.quoteReplacement(escaped(found)));
  }

  private static String escaped(MatchResult found) {
    return switch (found.group(1)) {
      case "r" -> "\r";
      case "n" -> "\n";
      case "0" -> "\0";
      case "s" -> " ";
      default -> Character.toString((char) Integer.parseInt(found.group(2), 16));
    };
  }
}
