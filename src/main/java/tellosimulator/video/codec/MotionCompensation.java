package tellosimulator.video.codec;

/**
 * Inter prediction with fractional sample interpolation (H.264, 8.4.2.2). Luma is interpolated at
 * quarter-sample positions with the six-tap filter, chroma bilinearly at eighths of a sample. Four
 * samples are processed at once in lanes of 16 bits ({@link Swar}).
 *
 * <p>A sum of six taps is between -2550 and 10710. Lanes are unsigned, so sums contain a bias,
 * which is subtracted before they are clipped to a byte.
 */
final class MotionCompensation {

  private static final int STRIDE = MacroblockSamples.STRIDE;

  /** The bias of a sum: a multiple of 32 above 2550, so that no biased sum is negative. */
  private static final int BIAS = 2560;

  /**
   * The bias of a difference between two values, each of which is the sum of two biased sums. It is
   * a multiple of 4 above 26520, the largest such difference.
   */
  private static final long DIFFERENCE_BIAS = Swar.broadcast16(26624);

  /** The bias that remains after all divisions: ((26624 / 4 + 26624) / 4 + 2 * 2560) / 64. */
  private static final long CENTER_BIAS = Swar.broadcast16(210);

  private static final long SAMPLE_BIAS = Swar.broadcast16(BIAS / 32);

  private static final long SIGN_BITS = 0x8000_8000_8000_8000L;

  private final byte[] second = new byte[MacroblockSamples.CB];

  /**
   * Intermediate sums of the horizontal filter for 16 rows and five additional ones. Each row takes
   * two words for even columns and two for odd columns.
   */
  private final long[] sums = new long[21 * 4];

  /**
   * Predicts 16x16 luma samples.
   *
   * @param x x of the upper left sample [quarter samples]
   * @param y y of the upper left sample [quarter samples]
   */
  void luma(Plane plane, int x, int y, MacroblockSamples to) {
    int at = plane.offset(x >> 2, y >> 2);
    int fracX = x & 3;
    int fracY = y & 3;
    int rightAt = fracX == 3 ? at + 1 : at;
    int belowAt = fracY == 3 ? at + plane.stride : at;
    byte[] first = to.bytes;
    if (fracX == 0 && fracY == 0) {
      copy(plane, at, first);
    } else if (fracY == 0) {
      halfPelHorizontal(plane, at, first);
      if (fracX != 2) {
        copy(plane, rightAt, second);
        average(first);
      }
    } else if (fracX == 0) {
      halfPelVertical(plane, at, first);
      if (fracY != 2) {
        copy(plane, belowAt, second);
        average(first);
      }
    } else {
      diagonal(plane, at, x, y, first);
    }
  }

  /**
   * Predicts 8x8 samples of Cb or Cr.
   *
   * @param x x of the upper left sample [eighths of a sample]
   * @param y y of the upper left sample [eighths of a sample]
   * @param at offset in {@code to}
   */
  void chroma(Plane plane, int x, int y, byte[] to, int at) {
    int fracX = x & 7;
    int fracY = y & 7;
    byte[] samples = plane.bytes;
    int from = plane.offset(x >> 3, y >> 3);
    if ((fracX | fracY) == 0) {
      for (int i = at; i < MacroblockSamples.STRIDE * 24; i += STRIDE) {
        Swar.store(to, i, Swar.load(samples, from));
        from += plane.stride;
      }
      return;
    }
    long here = Swar.load(samples, from);
    long beside = Swar.load(samples, from + 1);
    long even = lerp8(even(here), even(beside), fracX);
    long odd = lerp8(odd(here), odd(beside), fracX);
    for (int i = at; i < MacroblockSamples.STRIDE * 24; i += STRIDE) {
      from += plane.stride;
      here = Swar.load(samples, from);
      beside = Swar.load(samples, from + 1);
      long evenBelow = lerp8(even(here), even(beside), fracX);
      long oddBelow = lerp8(odd(here), odd(beside), fracX);
      long evenSum = lerp8(even, evenBelow, fracY);
      long oddSum = lerp8(odd, oddBelow, fracY);
      Swar.store(to, i, round6(evenSum) | (round6(oddSum) << 8));
      even = evenBelow;
      odd = oddBelow;
    }
  }

  /** Interpolates linearly in eighths; the result is multiplied by 8. */
  private static long lerp8(long from, long to, int frac) {
    return (from << 3) + (to - from) * frac;
  }

  private static long round6(long sums) {
    return ((sums + Swar.broadcast16(32)) >>> 6) & Swar.LOW_BYTES;
  }

  /**
   * Predicts a block at a position with a fraction in both directions: e, f, g, i, j, k, p, q or r
   * of the standard.
   */
  private void diagonal(Plane plane, int at, int x, int y, byte[] first) {
    int rightAt = (x & 3) == 3 ? at + 1 : at;
    int belowAt = (y & 3) == 3 ? at + plane.stride : at;
    if ((x & 1) != 0 && (y & 1) != 0) {
      halfPelHorizontal(plane, belowAt, first);
      halfPelVertical(plane, rightAt, second);
      average(first);
      return;
    }
    halfPelCenter(plane, at, first);
    if ((y & 1) != 0) {
      halfPelFromSums((y & 3) == 3 ? 3 : 2, second);
      average(first);
    } else if ((x & 1) != 0) {
      halfPelVertical(plane, rightAt, second);
      average(first);
    }
  }

  private static void copy(Plane plane, int at, byte[] to) {
    int from = at;
    for (int i = 0; i < MacroblockSamples.CB; i += STRIDE) {
      Swar.store(to, i, Swar.load(plane.bytes, from));
      Swar.store(to, i + 8, Swar.load(plane.bytes, from + 8));
      from += plane.stride;
    }
  }

  /** Averages two predictions, as required for quarter-sample positions. */
  private void average(byte[] first) {
    for (int i = 0; i < MacroblockSamples.CB; i += 8) {
      Swar.store(first, i, Swar.average(Swar.load(first, i), Swar.load(second, i)));
    }
  }

  /** Predicts a block at position b: half a sample to the right. */
  private static void halfPelHorizontal(Plane plane, int at, byte[] to) {
    byte[] samples = plane.bytes;
    int row = at;
    for (int i = 0; i < MacroblockSamples.CB; i += STRIDE) {
      for (int half = 0; half < STRIDE; half += 8) {
        int from = row + half;
        long before = Swar.load(samples, from - 2);
        long here = Swar.load(samples, from);
        long after = Swar.load(samples, from + 2);
        long last = even(Swar.load(samples, from + 4));
        long even =
            sixTap(even(before) + odd(after), odd(before) + even(after), even(here) + odd(here));
        long odd = sixTap(odd(before) + last, even(here) + odd(after), odd(here) + even(after));
        Swar.store(to, i + half, pack(round5Biased(even), round5Biased(odd), SAMPLE_BIAS));
      }
      row += plane.stride;
    }
  }

  /** Predicts a block at position h: half a sample down. */
  private static void halfPelVertical(Plane plane, int at, byte[] to) {
    byte[] samples = plane.bytes;
    int stride = plane.stride;
    for (int half = 0; half < STRIDE; half += 8) {
      int from = at + half - 2 * stride;
      long a = Swar.load(samples, from);
      long b = Swar.load(samples, from + stride);
      long c = Swar.load(samples, from + 2 * stride);
      long d = Swar.load(samples, from + 3 * stride);
      long e = Swar.load(samples, from + 4 * stride);
      for (int i = half; i < MacroblockSamples.CB; i += STRIDE) {
        long f = Swar.load(samples, from + 5 * stride);
        long even = sixTap(even(a) + even(f), even(b) + even(e), even(c) + even(d));
        long odd = sixTap(odd(a) + odd(f), odd(b) + odd(e), odd(c) + odd(d));
        Swar.store(to, i, pack(round5Biased(even), round5Biased(odd), SAMPLE_BIAS));
        from += stride;
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
      }
    }
  }

  /**
   * Predicts a block at position j: half a sample to the right and down. The horizontal sums are
   * kept for {@link #halfPelFromSums}.
   */
  private void halfPelCenter(Plane plane, int at, byte[] to) {
    filterRows(plane, at - 2 * plane.stride);
    for (int i = 0; i < 16; i++) {
      int row = 4 * i;
      for (int half = 0; half < 2; half++) {
        Swar.store(
            to,
            STRIDE * i + 8 * half,
            pack(halfPelCenter(row + half), halfPelCenter(row + half + 2), CENTER_BIAS));
      }
    }
  }

  /** Predicts a block at position b or s from the sums that {@link #halfPelCenter} has stored. */
  private void halfPelFromSums(int firstRow, byte[] to) {
    for (int i = 0; i < 16; i++) {
      int row = 4 * (i + firstRow);
      for (int half = 0; half < 2; half++) {
        long even = round5(sums[row + half]);
        long odd = round5(sums[row + half + 2]);
        Swar.store(to, STRIDE * i + 8 * half, pack(even, odd, SAMPLE_BIAS));
      }
    }
  }

  /** Fills the intermediate sums. */
  private void filterRows(Plane plane, int at) {
    byte[] samples = plane.bytes;
    long bias = Swar.broadcast16(BIAS);
    int row = at;
    for (int i = 0; i < sums.length; i += 4) {
      for (int half = 0; half < 2; half++) {
        int from = row + 8 * half;
        long before = Swar.load(samples, from - 2);
        long here = Swar.load(samples, from);
        long after = Swar.load(samples, from + 2);
        long last = even(Swar.load(samples, from + 4));
        sums[i + half] =
            bias
                + sixTap(
                    even(before) + odd(after), odd(before) + even(after), even(here) + odd(here));
        sums[i + half + 2] =
            bias + sixTap(odd(before) + last, even(here) + odd(after), odd(here) + even(after));
      }
      row += plane.stride;
    }
  }

  /**
   * Applies the vertical filter to horizontal sums, and divides by 1024; the result contains a
   * bias. Lanes of 16 bits suffice, because (outer - 5 middle + 20 inner) / 16 = ((outer - middle)
   * / 4 + (inner - middle)) / 4 + inner holds even if each division is rounded down. The second
   * division halves its operands first, because their sum alone could overflow.
   */
  private long halfPelCenter(int index) {
    long outer = sums[index] + sums[index + 20];
    long middle = sums[index + 4] + sums[index + 16];
    long inner = sums[index + 8] + sums[index + 12];
    long slope = ((outer + DIFFERENCE_BIAS - middle) >>> 2) & Swar.broadcast16(0x3FFF);
    long gap = inner + DIFFERENCE_BIAS - middle;
    long half = (slope & gap) + (((slope ^ gap) >>> 1) & Swar.broadcast16(0x7FFF));
    long sixteenth = ((half >>> 1) & Swar.broadcast16(0x7FFF)) + inner;
    return ((sixteenth + Swar.broadcast16(32)) >>> 6) & Swar.broadcast16(0x03FF);
  }

  private static long even(long word) {
    return word & Swar.LOW_BYTES;
  }

  private static long odd(long word) {
    return (word >>> 8) & Swar.LOW_BYTES;
  }

  /** Applies the taps 1, -5, 20, 20, -5, 1 to the sums of sample pairs. */
  private static long sixTap(long outer, long middle, long inner) {
    long four = (inner << 2) - middle;
    return outer + (four << 2) + four;
  }

  /** Computes (sum + 16) >> 5 for unbiased sums. The result is biased. */
  private static long round5Biased(long sums) {
    return round5(sums + Swar.broadcast16(BIAS));
  }

  private static long round5(long biased) {
    return ((biased + Swar.broadcast16(16)) >>> 5) & Swar.broadcast16(0x07FF);
  }

  /** Removes the bias, clips the values, and interleaves even and odd columns. */
  private static long pack(long even, long odd, long bias) {
    long evenBytes = even - bias;
    long oddBytes = odd - bias;
    if (((evenBytes | oddBytes) & ~Swar.LOW_BYTES) != 0) {
      return clip1(even, bias) | (clip1(odd, bias) << 8);
    }
    return evenBytes | (oddBytes << 8);
  }

  /**
   * Computes Clip1 of the standard: removes the bias and clips to the range from 0 to 255. Lanes
   * must be below 512 after the bias is removed.
   */
  private static long clip1(long biased, long bias) {
    long signed = (biased | SIGN_BITS) - bias;
    long nonNegativeMask = (signed >>> 15) & Swar.broadcast16(1);
    long atLeastZero = signed & ((nonNegativeMask << 16) - nonNegativeMask) & ~SIGN_BITS;
    long over = (atLeastZero >>> 8) & Swar.broadcast16(1);
    return (atLeastZero | ((over << 8) - over)) & Swar.LOW_BYTES;
  }
}
