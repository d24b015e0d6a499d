package tellosimulator.words;

import java.util.Locale;

/**
 * Makes text from outside the program safe for a terminal. Names and messages may contain control
 * sequences, which a terminal would execute, and marks that change the direction of the subsequent
 * text.
 */
public final class Printable {

  /** Maximum length of a quotation in a message [characters]. */
  private static final int LONGEST_QUOTATION = 40;

  private static final int ZERO_WIDTH_NON_JOINER = 0x200c;
  private static final int ZERO_WIDTH_JOINER = 0x200d;

  private Printable() {}

  /**
   * Replaces control and invisible formatting characters by escapes, such as {@code \x1b}. Tabs,
   * line feeds and zero-width joiners are kept.
   */
  public static String of(String text) {
    if (text.codePoints().allMatch(Printable::isHarmless)) {
      return text;
    }
    StringBuilder out = new StringBuilder();
    for (int c : text.codePoints().toArray()) {
      if (isHarmless(c)) {
        out.appendCodePoint(c);
      } else {
        out.append(String.format(Locale.ROOT, c < 0x100 ? "\\x%02x" : "\\u%04x", c));
      }
    }
    return out.toString();
  }

  /**
   * Quotes a text on one line: control characters become spaces, and the end of a long text is left
   * out.
   */
  public static String quoted(String text) {
    String clean =
        text.codePoints()
            .map(c -> Character.isISOControl(c) ? ' ' : c)
            .limit(LONGEST_QUOTATION)
            .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
            .toString();
    return "\"" + clean + (clean.length() < text.length() ? "…" : "") + "\"";
  }

  private static boolean isHarmless(int c) {
    return switch (Character.getType(c)) {
      case Character.CONTROL -> c == '\n' || c == '\t';
      case Character.FORMAT -> c == ZERO_WIDTH_NON_JOINER || c == ZERO_WIDTH_JOINER;
      case Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.SURROGATE -> false;
      default -> true;
    };
  }
}
