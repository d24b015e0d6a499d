package tellosimulator.video.picture;

import java.util.Arrays;

/**
 * A picture as encoders take it: brightness (Y) of each pixel, and two colour differences (U and V)
 * of each square of four pixels, one byte each without sign, row by row from the top. ITU-R BT.601
 * with 16 to 235 for brightness, which is what decoders assume where a stream says nothing.
 *
 * <p>It is used again and again: who draws writes the planes, who encodes reads them. For one
 * thread at a time.
 */
public final class Picture {

  private final int width;
  private final int height;
  private final byte[] y;
  private final byte[] u;
  private final byte[] v;

  /**
   * A black picture.
   *
   * @param width pixels, even
   * @param height pixels, even
   */
  public Picture(int width, int height) {
    if (width <= 0 || height <= 0 || width % 2 != 0 || height % 2 != 0) {
      throw new IllegalArgumentException(
          "picture is " + width + " by " + height + ", but both must be even and positive");
    }
    this.width = width;
    this.height = height;
    y = new byte[width * height];
    u = new byte[width * height / 4];
    v = new byte[width * height / 4];
    Arrays.fill(y, (byte) 16);
    Arrays.fill(u, (byte) 128);
    Arrays.fill(v, (byte) 128);
  }

  /** A picture of its own that looks the same. */
  public Picture copy() {
    Picture copy = new Picture(width, height);
    copy.set(this);
    return copy;
  }

  /** Takes over how another picture of the same size looks. */
  public void set(Picture other) {
    System.arraycopy(other.y, 0, y, 0, y.length);
    System.arraycopy(other.u, 0, u, 0, u.length);
    System.arraycopy(other.v, 0, v, 0, v.length);
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** The brightness itself, not a copy. */
  public byte[] y() {
    return y;
  }

  /** The blue difference itself, not a copy; half as wide and half as high. */
  public byte[] u() {
    return u;
  }

  /** The red difference itself, not a copy; half as wide and half as high. */
  public byte[] v() {
    return v;
  }
}
