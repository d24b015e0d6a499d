package tellosimulator.scenery.texture;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import tellosimulator.scenery.mesh.Texture;

/**
 * A texture that comes with the program as a PNG file: 8-bit RGB, not interlaced. Read by hand, as
 * {@code javax.imageio} takes 0.1 s to start, for which a first frame would wait. For any thread.
 */
public final class PngResource {

  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int IHDR = 0x49484452;
  private static final int IDAT = 0x49444154;
  private static final int IEND = 0x49454e44;

  /** Eight bits a sample, colour type RGB, the only methods of compression and filtering. */
  private static final byte[] RGB = {8, 2, 0, 0, 0};

  /** Bytes a pixel. */
  private static final int PIXEL = 3;

  private PngResource() {}

  /**
   * A square texture, read when it is first used.
   *
   * @param owner a class in whose package the resource is
   * @param size its edge [texels]
   */
  public static Texture texture(Class<?> owner, String file, int size) {
    return Texture.lazy(size, size, () -> read(owner, file, size));
  }

  private static int[] read(Class<?> owner, String file, int size) {
    try (InputStream resource = owner.getResourceAsStream(file)) {
      if (resource == null) {
        throw new IOException("there is no such resource");
      }
      return decode(new DataInputStream(resource), size);
    } catch (IOException | DataFormatException e) {
      throw new IllegalStateException(file + " in the program's jar cannot be read", e);
    }
  }

  /**
   * Decodes an image.
   *
   * @return alpha, red, green and blue, row by row
   */
  static int[] decode(DataInputStream png, int size) throws IOException, DataFormatException {
    if (png.readLong() != SIGNATURE) {
      throw new IOException("it is no PNG file");
    }
    Inflater inflater = new Inflater();
    try {
      byte[] rows = new byte[size * (1 + PIXEL * size)];
      int inflated = 0;
      for (int length = png.readInt(), type = png.readInt(); type != IEND; ) {
        byte[] chunk = png.readNBytes(length);
        if (type == IHDR) {
          checkHeader(chunk, size);
        } else if (type == IDAT) {
          inflater.setInput(chunk);
          inflated += inflater.inflate(rows, inflated, rows.length - inflated);
        }
        png.readInt(); // the checksum, which the jar has too
        length = png.readInt();
        type = png.readInt();
      }
      if (inflated < rows.length) {
        throw new IOException("it ends too early");
      }
      return pixels(rows, size);
    } finally {
      inflater.end();
    }
  }

  private static void checkHeader(byte[] header, int size) throws IOException {
    boolean rgb = Arrays.equals(header, 8, 13, RGB, 0, RGB.length);
    int width = ((header[2] & 255) << 8) | (header[3] & 255);
    int height = ((header[6] & 255) << 8) | (header[7] & 255);
    if (!rgb || width != size || height != size) {
      throw new IOException("it must have 8-bit RGB pixels, " + size + " by " + size);
    }
  }

  /** Undoes the filter of each row, in place, and packs the pixels. */
  private static int[] pixels(byte[] rows, int size) throws IOException {
    int[] argb = new int[size * size];
    byte[] above = new byte[PIXEL * size];
    byte[] row = new byte[PIXEL * size];
    for (int y = 0; y < size; y++) {
      int start = y * (1 + row.length);
      System.arraycopy(rows, start + 1, row, 0, row.length);
      unfilter(rows[start], row, above);
      for (int x = 0, i = 0; x < size; x++, i += PIXEL) {
        argb[y * size + x] =
            0xff000000 | (row[i] & 255) << 16 | (row[i + 1] & 255) << 8 | (row[i + 2] & 255);
      }
      byte[] next = above;
      above = row;
      row = next;
    }
    return argb;
  }

  /** Adds to each byte of a row its prediction. Documented: PNG specification, 9. */
  private static void unfilter(int filter, byte[] row, byte[] above) throws IOException {
    switch (filter) {
      case 0 -> {}
      case 1 -> addLeft(row);
      case 2 -> addAbove(row, above);
      case 3, 4 -> addMixed(filter, row, above);
      default -> throw new IOException("filter " + filter + " is unknown");
    }
  }

  private static void addLeft(byte[] row) {
    for (int i = PIXEL; i < row.length; i++) {
      row[i] += row[i - PIXEL];
    }
  }

  private static void addAbove(byte[] row, byte[] above) {
    for (int i = 0; i < row.length; i++) {
      row[i] += above[i];
    }
  }

  private static void addMixed(int filter, byte[] row, byte[] above) {
    for (int i = 0; i < row.length; i++) {
      int left = i < PIXEL ? 0 : row[i - PIXEL] & 255;
      int corner = i < PIXEL ? 0 : above[i - PIXEL] & 255;
      int up = above[i] & 255;
      row[i] += (byte) (filter == 3 ? (left + up) / 2 : paeth(left, up, corner));
    }
  }

  private static int paeth(int left, int above, int corner) {
    int guess = left + above - corner;
    int toLeft = Math.abs(guess - left);
    int toAbove = Math.abs(guess - above);
    int toCorner = Math.abs(guess - corner);
    if (toLeft <= toAbove && toLeft <= toCorner) {
      return left;
    }
    return toAbove <= toCorner ? above : corner;
  }
}
