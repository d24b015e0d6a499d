package tellosimulator.fault;

import java.nio.charset.StandardCharsets;

/**
 * The corruption of a datagram: which bytes change, and how. Immutable.
 *
 * @param bits random bits that determine the corruption; 0 for none
 */
public record Corruption(long bits) {

  /** No corruption. */
  public static final Corruption NONE = new Corruption(0);

  private static final int BYTE = 0xff;

  /** Returns a copy with one to three corrupted bytes. */
  public byte[] applied(byte[] bytes) {
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    return applied(text).getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * Returns a copy of a text with one to three corrupted bytes.
   *
   * @param text the text, one character per byte (ISO-8859-1)
   */
  public String applied(String text) {
    if (bits == 0 || text.isEmpty()) {
      return text;
    }
    StringBuilder wrong = new StringBuilder(text);
    long rest = bits;
    int bytes = 1 + (int) Math.floorMod(rest, 3L);
    for (int i = 0; i < bytes; i++) {
      rest = rest * 0x5deece66dL + 11; // spreads the positions
      int at = (int) Math.floorMod(rest >>> 16, (long) text.length());
      int mask = 1 + (int) Math.floorMod(rest >>> 40, (long) BYTE);
      wrong.setCharAt(at, (char) ((text.charAt(at) ^ mask) & BYTE));
    }
    return wrong.toString();
  }
}
