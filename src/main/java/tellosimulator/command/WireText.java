package tellosimulator.command;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;

/**
 * Converts bytes on the wire to texts and back, without loss: one character per byte (ISO-8859-1).
 */
public final class WireText {

  /**
   * Maximum length of a command and of an echo [bytes]. Decided, because no source gives a limit.
   */
  public static final int LONGEST = 1024;

  /**
   * Appended to a packet of the app's protocol in words, because the text protocol has commands of
   * the same names.
   */
  public static final String APP_SUFFIX = " (app)";

  private static final int LONGEST_SHOWN = 80;

  /** The commands {@code rc} and {@code emergency}, to which the drone never replies. */
  private static final Set<String> UNANSWERED =
      Set.of(CommandSyntax.RC.verb(), CommandSyntax.EMERGENCY.verb());

  private static final byte[][] FIRST_WORDS =
      CommandSyntax.FIRST_WORDS.stream().map(WireText::encode).toArray(byte[][]::new);

  private WireText() {}

  public static String decode(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }

  public static byte[] encode(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Removes all trailing CR, LF and NUL, and one trailing space. */
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
   * Returns whether a datagram begins with the first word of a command of any product, possibly
   * after a header. Whether the datagram really is a command depends on its other words.
   */
  public static boolean beginsLikeCommand(String datagram) {
    return beginsLikeCommand(encode(datagram), datagram.length());
  }

  /**
   * Returns the same as {@link #beginsLikeCommand(String)} for the bytes of a datagram. Allocates
   * nothing, because it is called for every datagram of a flood.
   *
   * @param bytes an array that begins with the datagram
   * @param length the length of the datagram [bytes]
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

  /**
   * Whether a command is {@code rc} or {@code emergency}, to which the drone never replies.
   *
   * @param datagram a datagram that contains a command
   */
  public static boolean isUnanswered(String datagram) {
    return UNANSWERED.contains(firstWord(datagram));
  }

  /** Whether a command moves the sticks, in either protocol. */
  public static boolean isSteering(String command) {
    return command.startsWith(CommandSyntax.RC.verb() + " ");
  }

  /** Whether a command only reads a value, in either protocol. */
  public static boolean isRead(String command) {
    return command.endsWith("?") || command.endsWith("?" + APP_SUFFIX);
  }

  private static String firstWord(String datagram) {
    int start = Retransmission.header(datagram).length();
    int end = start;
    while (end < datagram.length() && datagram.charAt(end) > ' ') {
      end++;
    }
    return datagram.substring(start, end);
  }

  /** Escapes and truncates a text, so that it is safe in terminals and logs. */
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
