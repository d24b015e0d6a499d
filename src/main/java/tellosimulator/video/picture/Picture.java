package tellosimulator.video.picture;

import java.util.Arrays;

/**
 * A picture in the format that encoders use (4:2:0): the luma (Y) of each pixel, and two chroma
 * values (U and V) for each square of four pixels, as unsigned bytes, row by row from the top. The
 * values follow ITU-R BT.601, with luma from 16 to 235. Decoders assume this if a stream does not
 * specify its colour space.
 *
 * <p>Pictures are reused: the renderer writes the planes, and the encoder reads them. Used by one
 * thread at a time.
 */
public final class Picture {

  private final int width;
  private final int height;
  private final byte[] y;
  private final byte[] u;
  private final byte[] v;

  /**
   * Creates a black picture.
   *
   * @param width width of the picture [pixels], even
   * @param height height of the picture [pixels], even
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

  /** Returns an independent copy. */
  public Picture copy() {
    Picture copy = new Picture(width, height);
    copy.set(this);
    return copy;
  }

  /** Copies the content of another picture of the same size. */
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

  /** The luma plane itself, not a copy. */
  public byte[] y() {
    return y;
  }

  /** The Cb plane itself, not a copy; half as wide and half as high. */
  public byte[] u() {
    return u;
  }

  /** The Cr plane itself, not a copy; half as wide and half as high. */
  public byte[] v() {
    return v;
  }
}
