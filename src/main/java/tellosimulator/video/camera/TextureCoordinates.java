package tellosimulator.video.camera;

/** The texture coordinates of a span. Reused for each span. Not thread-safe. */
final class TextureCoordinates {

  /** Half a texel, because bilinear filtering counts from the centres of texels. */
  private static final int HALF = MipMap.ONE / 2;

  private static final int QUARTER = MipMap.ONE / 4;

  /** The number of coordinates. */
  int count;

  /**
   * Fixed-point texels ({@link MipMap#ONE}) from the centre of the first texel. Overflow is
   * harmless, because textures wrap around.
   */
  int[] u = new int[0];

  int[] v = new int[0];

  /** The index of the texel at each coordinate, as computed by {@link BilinearTexels#index}. */
  int[] index = new int[0];

  private int startU;
  private int startV;

  void ensureCapacity(int capacity) {
    if (u.length < capacity) {
      u = new int[capacity];
      v = new int[capacity];
      index = new int[capacity];
    }
  }

  /** Sets the start of the next interpolation, in fixed-point texels from the texture's corner. */
  void setStart(double nextU, double nextV) {
    startU = (int) (long) nextU - HALF;
    startV = (int) (long) nextV - HALF;
  }

  /** Fills a range of coordinates by linear interpolation. */
  void interpolate(int from, int to, double stepU, double stepV) {
    int[] us = u;
    int[] vs = v;
    int atU = startU;
    int atV = startV;
    int addU = (int) stepU;
    int addV = (int) stepV;
    for (int i = from; i < to; i++) {
      us[i] = atU;
      vs[i] = atV;
      atU += addU;
      atV += addV;
    }
  }

  /** Computes the indices for all textures of the same size as this one. */
  void computeIndices(BilinearTexels texture) {
    computeIndices(u, v, index, count, texture.width(), texture.height());
  }

  private static void computeIndices(
      int[] u, int[] v, int[] index, int count, int width, int height) {
    // The same as BilinearTexels.index, for many coordinates at once.
    int right = (width - 1) << 2;
    int lowest = (height - 1) >> 2;
    int low = (height - 1) & 3;
    int stride = 4 * width;
    for (int i = 0; i < count; i++) {
      index[i] = ((v[i] >> 18) & lowest) * stride + ((u[i] >> 14) & right) + ((v[i] >> 16) & low);
    }
  }

  /**
   * Subsamples a span by two: averages each pair of coordinates, and converts the average to texels
   * of the next mip level.
   *
   * @param first index of the first pair
   */
  void subsample(TextureCoordinates full, int first) {
    count = (full.count - first + 1) / 2;
    if (count > 0) {
      subsample(full.u, u, first, count - 1);
      subsample(full.v, v, first, count - 1);
      int last = first + 2 * count - 2; // may lack a second coordinate
      int next = Math.min(last + 1, full.count - 1);
      u[count - 1] = (full.u[last] >> 2) + (full.u[next] >> 2) - QUARTER;
      v[count - 1] = (full.v[last] >> 2) + (full.v[next] >> 2) - QUARTER;
    }
  }

  private static void subsample(int[] full, int[] half, int first, int count) {
    for (int i = 0; i < count; i++) {
      half[i] = (full[2 * i + first] >> 2) + (full[2 * i + first + 1] >> 2) - QUARTER;
    }
  }
}
