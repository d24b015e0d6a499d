package tellosimulator.scenery.texture;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import tellosimulator.scenery.mesh.Texture;

/**
 * A texture that comes with the program as a PNG file: an 8-bit palette, not interlaced. Read by
 * hand, as {@code javax.imageio} takes 0.1 s to start, for which a first frame would wait. For any
 * thread.
 */
public final class PngResource {

  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int IHDR = 0x49484452;
  private static final int PLTE = 0x504c5445;
  private static final int IDAT = 0x49444154;
  private static final int IEND = 0x49454e44;

  /** Eight bits a sample, indexed colour, the only methods of compression and filtering. */
  private static final byte[] INDEXED = {8, 3, 0, 0, 0};

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
      byte[] rows = new byte[size * (1 + size)];
      int[] palette = new int[256];
      int inflated = 0;
      for (int length = png.readInt(), type = png.readInt(); type != IEND; ) {
        byte[] chunk = png.readNBytes(length);
        if (type == IHDR) {
          checkHeader(chunk, size);
        } else if (type == PLTE) {
          fill(palette, chunk);
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
      return pixels(rows, palette, size);
    } finally {
      inflater.end();
    }
  }

  private static void checkHeader(byte[] header, int size) throws IOException {
    boolean indexed = Arrays.equals(header, 8, 13, INDEXED, 0, INDEXED.length);
    int width = ((header[2] & 255) << 8) | (header[3] & 255);
    int height = ((header[6] & 255) << 8) | (header[7] & 255);
    if (!indexed || width != size || height != size) {
      throw new IOException("it must have an 8-bit palette, and pixels " + size + " by " + size);
    }
  }

  private static void fill(int[] palette, byte[] chunk) {
    for (int color = 0, i = 0; i + 2 < chunk.length; color++, i += 3) {
      palette[color] =
          0xff000000 | (chunk[i] & 255) << 16 | (chunk[i + 1] & 255) << 8 | (chunk[i + 2] & 255);
    }
  }

  /** Undoes the filters of the rows, and looks the colours up. */
  private static int[] pixels(byte[] rows, int[] palette, int size) throws IOException {
    int[] argb = new int[size * size];
    int[] above = new int[size + 1]; // indexes of colours, after a 0 at the left
    int next = 0;
    for (int y = 0; y < size; y++) {
      int filter = rows[next++];
      int[] row = new int[size + 1];
      for (int x = 1; x <= size; x++) {
        row[x] = (rows[next++] + predicted(filter, row[x - 1], above[x], above[x - 1])) & 255;
        argb[y * size + x - 1] = palette[row[x]];
      }
      above = row;
    }
    return argb;
  }

  /** What a filter expects a byte to be. Documented: PNG specification, section 9.2. */
  private static int predicted(int filter, int left, int above, int aboveLeft) throws IOException {
    return switch (filter) {
      case 0 -> 0;
      case 1 -> left;
      case 2 -> above;
      case 3 -> (left + above) / 2;
      case 4 -> paeth(left, above, aboveLeft);
      default -> throw new IOException("there is no filter " + filter);
    };
  }

  private static int paeth(int left, int above, int aboveLeft) {
    int estimate = left + above - aboveLeft;
    int toLeft = Math.abs(estimate - left);
    int toAbove = Math.abs(estimate - above);
    int toAboveLeft = Math.abs(estimate - aboveLeft);
    if (toLeft <= toAbove && toLeft <= toAboveLeft) {
      return left;
    }
    return toAbove <= toAboveLeft ? above : aboveLeft;
  }
}
