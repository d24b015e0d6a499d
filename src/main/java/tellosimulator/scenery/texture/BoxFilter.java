package tellosimulator.scenery.texture;

import java.util.Arrays;
import tellosimulator.scenery.mesh.Texture;

/**
 * Resamples an image to powers of two with a box filter: each new texel is the mean of the pixels
 * that it covers. Large images then do not flicker. Edges in a small image, such as a marker of
 * only a few pixels, stay sharp.
 */
final class BoxFilter {

  /**
   * Maximum width and height [pixels]. Decided: about the resolution of a camera, for a poster that
   * fills its view.
   */
  static final int LARGEST = 1024;

  /** Minimum width and height [pixels]. Decided: enough for sharp edges between pixels. */
  static final int SMALLEST = 256;

  private BoxFilter() {}

  static Texture resample(Texture image) {
    int width = powerOfTwo(image.width());
    int height = powerOfTwo(image.height());
    if (width == image.width() && height == image.height()) {
      return image;
    }
    int[] pixels = new int[width * height];
    double[] sums = new double[4];
    for (int y = 0; y < height; y++) {
      Span rows = Span.of(y, height, image.height());
      for (int x = 0; x < width; x++) {
        pixels[y * width + x] = mean(image, Span.of(x, width, image.width()), rows, sums);
      }
    }
    return new Texture(width, height, pixels);
  }

  private static int powerOfTwo(int size) {
    int rounded = Integer.highestOneBit(size);
    int enough = rounded < size ? 2 * rounded : rounded;
    return Math.max(SMALLEST, Math.min(LARGEST, enough));
  }

  /** The range of old pixels that a new pixel covers, measured from the first edge of the image. */
  private record Span(double from, double to) {

    static Span of(int pixel, int pixels, int old) {
      return new Span((double) pixel * old / pixels, (double) (pixel + 1) * old / pixels);
    }

    double of(int pixel) {
      return Math.min(to, pixel + 1) - Math.max(from, pixel);
    }
  }

  private static int mean(Texture image, Span columns, Span rows, double[] sums) {
    Arrays.fill(sums, 0);
    double covered = 0;
    for (int y = (int) rows.from; y < rows.to && y < image.height(); y++) {
      for (int x = (int) columns.from; x < columns.to && x < image.width(); x++) {
        int argb = image.argb(x, y);
        double weight = rows.of(y) * columns.of(x);
        double alpha = weight * (argb >>> 24);
        covered += weight;
        sums[0] += alpha;
        sums[1] += alpha * (argb >> 16 & 0xff);
        sums[2] += alpha * (argb >> 8 & 0xff);
        sums[3] += alpha * (argb & 0xff);
      }
    }
    double solid = Math.max(sums[0], 1e-9);
    return rounded(sums[0] / covered) << 24
        | rounded(sums[1] / solid) << 16
        | rounded(sums[2] / solid) << 8
        | rounded(sums[3] / solid);
  }

  private static int rounded(double value) {
    return (int) Math.round(value);
  }
}
