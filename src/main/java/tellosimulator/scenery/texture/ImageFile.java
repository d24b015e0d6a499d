package tellosimulator.scenery.texture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import tellosimulator.scenery.mesh.Texture;

/**
 * Reads the user's image files, which may take a long time, and the image files in the program's
 * jar. Thread-safe.
 */
public final class ImageFile {

  /**
   * Maximum number of pixels in an image. Decided: more than most phone cameras produce, and still
   * quick to read.
   */
  private static final long MOST_PIXELS = 1L << 26;

  /**
   * Maximum width and height [pixels]. They are limited because readers hold whole rows in memory.
   * Decided: half of the JPEG limit.
   */
  private static final int LONGEST_EDGE = 1 << 15;

  /**
   * Minimum width and height that remain when a larger image is subsampled while it is read
   * [pixels]. Decided: twice the size at which images are kept.
   */
  private static final int LARGE = 2 * BoxFilter.LARGEST;

  /**
   * The accepted formats, by the names of their readers. Java supports further formats, which are
   * not needed.
   */
  private static final Set<String> FORMATS = Set.of("png", "jpeg", "gif", "bmp");

  private ImageFile() {}

  /**
   * Reads an image and scales it down if it is large.
   *
   * @param file PNG, JPEG, GIF or BMP
   * @throws IOException with a message for people, if the file does not exist, is not an image, is
   *     too large, or does not fit into memory
   */
  public static ImageTexture read(String file) throws IOException {
    Path path = path(file);
    try (ImageInputStream input = ImageIO.createImageInputStream(path.toFile())) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(input);
      ImageReader reader = readers.hasNext() ? readers.next() : null;
      if (reader == null || !FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
        throw unreadable(file);
      }
      try {
        reader.setInput(input, true, true);
        return read(reader, file);
      } finally {
        reader.dispose();
      }
    }
  }

  /**
   * Checks whether an image can be read. It reads the whole file, because otherwise a truncated
   * file would not be detected.
   *
   * @throws IOException with a message for people, if it cannot be read
   */
  @SuppressWarnings("ReturnValueIgnored")
  public static void check(String file) throws IOException {
    read(file);
  }

  /**
   * Returns an image in the program's jar as a square texture that is read on first use.
   *
   * @param owner a class in the package of the resource
   * @param size side length of the texture [texels]
   */
  public static Texture resource(Class<?> owner, String file, int size) {
    return Texture.lazy(size, size, () -> readResource(owner, file).argbArray());
  }

  private static Texture readResource(Class<?> owner, String file) {
    try (InputStream resource = owner.getResourceAsStream(file)) {
      return texture(ImageIO.read(resource));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Path path(String file) throws IOException {
    try {
      Path path = Path.of(file);
      if (!Files.exists(path)) {
        throw new IOException("there is no file " + file);
      }
      if (!Files.isRegularFile(path) || !Files.isReadable(path)) {
        throw new IOException("the file " + file + " cannot be read");
      }
      return path;
    } catch (InvalidPathException e) {
      throw new IOException("there is no file " + file, e);
    }
  }

  private static ImageTexture read(ImageReader reader, String file) throws IOException {
    try {
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      if (Math.max(width, height) > LONGEST_EDGE || (long) width * height > MOST_PIXELS) {
        throw new HugeImageException(file, width, height);
      }
      ImageReadParam some = reader.getDefaultReadParam();
      some.setSourceSubsampling(step(width), step(height), 0, 0);
      return new ImageTexture(
          BoxFilter.resample(texture(reader.read(0, some))), (double) height / width);
    } catch (HugeImageException e) {
      throw e;
    } catch (IOException | RuntimeException | OutOfMemoryError e) { // readers throw many types
      if (e instanceof OutOfMemoryError || e.getCause() instanceof OutOfMemoryError) {
        throw new IOException("there is not enough memory for the image " + file, e);
      }
      throw unreadable(file, e);
    }
  }

  /** Returns the subsampling factor for a width or a height. */
  private static int step(int pixels) {
    return Math.max(1, pixels / LARGE);
  }

  private static Texture texture(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    int[] pixels = new int[width * height];
    image.getRGB(0, 0, width, height, pixels, 0, width);
    if (image.getColorModel().getNumColorComponents() == 1
        && !(image.getColorModel() instanceof IndexColorModel)) {
      takeGray(image, pixels);
    }
    return new Texture(width, height, pixels);
  }

  /**
   * Copies grey samples unchanged. {@code getRGB} would treat them as linear and make them lighter.
   */
  private static void takeGray(BufferedImage image, int[] pixels) {
    Raster raster = image.getRaster();
    int[] row = new int[image.getWidth()];
    int most = (1 << image.getColorModel().getComponentSize(0)) - 1;
    for (int y = 0; y < image.getHeight(); y++) {
      raster.getSamples(0, y, row.length, 1, 0, row);
      for (int x = 0; x < row.length; x++) {
        int gray = row[x] * 255 / most;
        int pixel = y * row.length + x;
        pixels[pixel] = (pixels[pixel] & 0xff000000) | gray * 0x010101;
      }
    }
  }

  private static IOException unreadable(String file) {
    return new IOException(
        "the file " + file + " is not an image that can be read (PNG, JPEG, GIF or BMP)");
  }

  private static IOException unreadable(String file, Throwable cause) {
    IOException exception = unreadable(file);
    exception.initCause(cause);
    return exception;
  }

  private static final class HugeImageException extends IOException {

    private static final long serialVersionUID = 1;

    private HugeImageException(String file, int width, int height) {
      super(
          String.format(
              Locale.ROOT,
              "the image %s has %d by %d pixels, but an image may have %d along an edge and %d million"
                  + " in all at the most",
              file,
              width,
              height,
              LONGEST_EDGE,
              MOST_PIXELS / 1_000_000));
    }
  }
}
