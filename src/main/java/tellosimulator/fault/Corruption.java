package tellosimulator.fault;

import java.nio.charset.StandardCharsets;

/**
 * Which bytes of a datagram are wrong. Immutable.
 *
 * @param bits random; 0 for none
 */
public record Corruption(long bits) {

  /** All bytes are right. */
  public static final Corruption NONE = new Corruption(0);

  private static final int BYTE = 0xff;

  /** The same bytes, of which one to three are wrong. */
  public byte[] applied(byte[] bytes) {
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    return applied(text).getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * The same text with one to three wrong bytes.
   *
   * @param text one character a byte (ISO-8859-1)
   */
  public String applied(String text) {
    if (bits == 0 || text.isEmpty()) {
      return text;
    }
    StringBuilder wrong = new StringBuilder(text);
    long rest = bits;
    int bytes = 1 + (int) Math.floorMod(rest, 3L);
    for (int i = 0; i < bytes; i++) {
      rest = rest * 0x5deece66dL + 11; // so that positions are spread
      int at = (int) Math.floorMod(rest >>> 16, (long) text.length());
      int mask = 1 + (int) Math.floorMod(rest >>> 40, (long) BYTE);
      wrong.setCharAt(at, (char) ((text.charAt(at) ^ mask) & BYTE));
    }
    return wrong.toString();
  }
}
