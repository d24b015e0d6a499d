package tellosimulator.command;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;

/** Bytes of the wire as text and back, without loss: one character a byte (ISO-8859-1). */
public final class WireText {

  /** Longest datagram that can be a command, and longest echo [bytes]. Decided, no source. */
  public static final int LONGEST = 1024;

  private static final int LONGEST_SHOWN = 80;

  /** First words of commands that are never answered; see {@link CommandSyntax}. */
  private static final Set<String> UNANSWERED =
      Set.of(CommandSyntax.RC.verb(), CommandSyntax.EMERGENCY.verb());

  private static final byte[][] FIRST_WORDS =
      CommandSyntax.FIRST_WORDS.stream().map(WireText::encode).toArray(byte[][]::new);

  private WireText() {}

  public static String decode(byte[] bytes, int length) {
    return new String(bytes, 0, length, StandardCharsets.ISO_8859_1);
  }

  public static byte[] encode(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** The text without any trailing CR, LF and NUL and without one trailing blank. */
  static String trimmed(String text) {
    int end = text.length();
    boolean blankDropped = false;
    while (end > 0) {
      char last = text.charAt(end - 1);
      boolean blank = last == ' ' && !blankDropped;
      if (!blank && last != '\r' && last != '\n' && last != '\0') {
        break;
      }
      blankDropped |= blank;
      end--;
    }
    return text.substring(0, end);
  }

  /**
   * Whether a datagram begins with the first word of a command of any product, perhaps after a
   * header; whether it is one is up to its other words.
   */
  public static boolean beginsLikeCommand(String datagram) {
    return beginsLikeCommand(encode(datagram), datagram.length());
  }

  /**
   * The same of a datagram as it came. Makes no garbage, as floods are looked at.
   *
   * @param bytes begin with the datagram
   * @param length of the datagram [bytes]
   */
  public static boolean beginsLikeCommand(byte[] bytes, int length) {
    int start = Retransmission.headerLength(bytes, length);
    int end = start;
    while (end < length && (bytes[end] & 0xff) > ' ') {
      end++;
    }
    for (byte[] word : FIRST_WORDS) {
      if (Arrays.equals(bytes, start, end, word, 0, word.length)) {
        return true;
      }
    }
    return false;
  }

  /** Whether a datagram is a command that is never answered, if it is a command. */
  public static boolean isUnanswered(String datagram) {
    return UNANSWERED.contains(firstWord(datagram));
  }

  private static String firstWord(String datagram) {
    int start = Retransmission.header(datagram).length();
    int end = start;
    while (end < datagram.length() && datagram.charAt(end) > ' ') {
      end++;
    }
    return datagram.substring(start, end);
  }

  /** The text in a form that harms no terminal and no log: escaped and cut. */
  public static String printable(String text) {
    StringBuilder out = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      if (out.length() >= LONGEST_SHOWN) {
        return out.append("… (").append(text.length()).append(" bytes)").toString();
      }
      char c = text.charAt(i);
      boolean plain = c >= ' ' && c < 0x7f;
      out.append(plain ? Character.toString(c) : String.format(Locale.ROOT, "\\x%02x", (int) c));
    }
    return out.toString();
  }
}
