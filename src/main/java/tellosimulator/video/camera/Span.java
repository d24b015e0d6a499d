package tellosimulator.video.camera;

/**
 * A horizontal run of shaded pixels before the depth test. If the colour space subsamples chroma
 * ({@link ColorSpace#subsampled()}), the second and third channel have values only for even
 * columns. The arrays are reused for each span. Not thread-safe.
 */
final class Span {

  /** The column of the first pixel. */
  int x;

  /** The number of pixels. */
  int count;

  /** The first channel; all channels range from 0 to 255. */
  int[] first = new int[0];

  int[] second = new int[0];
  int[] third = new int[0];

  /** The alpha of each pixel, 0 to 255; set only for translucent spans. */
  int[] alpha = new int[0];

  /** The alpha of the second and third channel. */
  int[] chromaAlpha = new int[0];

  /** The blending weight of each pixel, 0 to 256; 0 where it is hidden. */
  int[] coverage = new int[0];

  /** The light on each pixel, 0 to 256; set only for lit spans. */
  int[] light = new int[0];

  void ensureCapacity(int pixels) {
    if (first.length < pixels) {
      first = new int[pixels];
      second = new int[pixels];
      third = new int[pixels];
      alpha = new int[pixels];
      chromaAlpha = new int[pixels];
      coverage = new int[pixels];
      light = new int[pixels];
    }
  }

  /** The index of the first pixel in an even column. */
  int firstEven() {
    return x & 1;
  }

  /** The number of pixels in even columns. */
  int evenCount() {
    return (count - firstEven() + 1) / 2;
  }

  /** Removes the coverage of odd columns. */
  void subsampleCoverage() {
    int from = firstEven();
    int size = evenCount();
    for (int i = 0; i < size; i++) {
      coverage[i] = coverage[2 * i + from];
    }
  }

  /** Modulates all channels by the light. */
  void modulate(ColorSpace space) {
    int black = space.black();
    modulate(first, 0, 1, count, black >> 16 & 255);
    int start = space.subsampled() ? firstEven() : 0;
    int step = space.subsampled() ? 2 : 1;
    int chromaCount = space.subsampled() ? evenCount() : count;
    modulate(second, start, step, chromaCount, black >> 8 & 255);
    modulate(third, start, step, chromaCount, black & 255);
  }

  private void modulate(int[] values, int start, int step, int size, int black) {
    int[] intensities = light;
    int at = start;
    for (int i = 0; i < size; i++, at += step) {
      int intensity = intensities[at];
      values[i] = (values[i] * intensity + black * (256 - intensity)) >> 8;
    }
  }
}
