package tellosimulator.scenery.texture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.IOException;
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

/** An image file of the person who runs the simulator. Reading takes its time; for any thread. */
public final class ImageFile {

  /** Most pixels of an image. Decided: more than cameras of phones take, and still quickly read. */
  private static final long MOST_PIXELS = 1L << 26;

  /** Longest edge [pixels], because readers hold whole rows. Decided: half of what JPEG allows. */
  private static final int LONGEST_EDGE = 1 << 15;

  /** From this edge on pixels are left out already while reading. Decided: twice what is kept. */
  private static final int LARGE = 2 * BoxFilter.LARGEST;

  /** Formats that are read, by their readers' names; Java knows others that nobody needs here. */
  private static final Set<String> FORMATS = Set.of("png", "jpeg", "gif", "bmp");

  private ImageFile() {}

  /**
   * Reads an image; a large one is scaled down.
   *
   * @param file PNG, JPEG, GIF or BMP
   * @throws IOException with a sentence for people, if there is no such file, if it is no image or
   *     a huge one, or if there is not enough memory for it
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
   * Looks whether an image can be read. It is read for that: only then it shows whether it is
   * whole.
   *
   * @throws IOException with a sentence for people, if it cannot
   */
  @SuppressWarnings("ReturnValueIgnored")
  public static void check(String file) throws IOException {
    read(file);
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
    } catch (IOException | RuntimeException | OutOfMemoryError e) { // readers throw many kinds
      if (e instanceof OutOfMemoryError || e.getCause() instanceof OutOfMemoryError) {
        throw new IOException("there is not enough memory for the image " + file, e);
      }
      throw unreadable(file, e);
    }
  }

  /** Of how many pixels along an edge one is read. */
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

  /** As it is in the file: {@code getRGB} takes grey for linear and would make it lighter. */
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
