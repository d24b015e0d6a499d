package tellosimulator.video.camera;

/** Where in a texture the pixels of a part of a row are. Filled anew for each; for one thread. */
final class Places {

  /** Half a pixel of the texture: its colours are those of its pixels' middles. */
  private static final int HALF = MipMaps.ONE / 2;

  private static final int QUARTER = MipMaps.ONE / 4;

  /** How many places there are. */
  int count;

  /**
   * In pixels of the texture from the middle of its first one, times {@link MipMaps#ONE}; what an
   * int cannot hold repeats anyway.
   */
  int[] u = new int[0];

  int[] v = new int[0];

  /** Which pixel of the texture it is: {@link Quads#index}. */
  int[] index = new int[0];

  private int startU;
  private int startV;

  /** From now on there is room for so many. */
  void room(int most) {
    if (u.length < most) {
      u = new int[most];
      v = new int[most];
      index = new int[most];
    }
  }

  /** From where the next places are filled, in pixels from the texture's corner, as {@link #u}. */
  void from(double nextU, double nextV) {
    startU = (int) (long) nextU - HALF;
    startV = (int) (long) nextV - HALF;
  }

  /** Fills some places evenly. */
  void fill(int from, int to, double stepU, double stepV) {
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

  /** Finds the pixels in all textures of the size of this one. */
  void find(Quads texture) {
    find(u, v, index, count, texture.width(), texture.height());
  }

  private static void find(int[] u, int[] v, int[] index, int count, int width, int height) {
    // As Quads.index, for many at once.
    int right = (width - 1) << 2;
    int lowest = (height - 1) >> 2;
    int low = (height - 1) & 3;
    int stride = 4 * width;
    for (int i = 0; i < count; i++) {
      index[i] = ((v[i] >> 18) & lowest) * stride + ((u[i] >> 14) & right) + ((v[i] >> 16) & low);
    }
  }

  /**
   * Takes the middles of each two places of others, in pixels of a texture half as wide and half as
   * high.
   *
   * @param first the first one's number
   */
  void halve(Places fine, int first) {
    count = (fine.count - first + 1) / 2;
    if (count > 0) {
      halve(fine.u, u, first, count - 1);
      halve(fine.v, v, first, count - 1);
      int last = first + 2 * count - 2; // may be alone
      int next = Math.min(last + 1, fine.count - 1);
      u[count - 1] = (fine.u[last] >> 2) + (fine.u[next] >> 2) - QUARTER;
      v[count - 1] = (fine.v[last] >> 2) + (fine.v[next] >> 2) - QUARTER;
    }
  }

  private static void halve(int[] fine, int[] half, int first, int count) {
    for (int i = 0; i < count; i++) {
      half[i] = (fine[2 * i + first] >> 2) + (fine[2 * i + first + 1] >> 2) - QUARTER;
    }
  }
}
