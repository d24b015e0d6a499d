package tellosimulator.video.codec;

/**
 * Predictions between the pixels of a frame: luma by quarters with H.264's filter of six taps,
 * colour by eighths. Works on four pixels at once in lanes of 16 bits.
 *
 * <p>A sum of six taps is between -2550 and 10710. Lanes have no sign, so sums carry a bias that is
 * taken off when they are cut to a byte.
 */
final class Interpolation {

  private static final int STRIDE = Samples.STRIDE;

  /** A multiple of 32 above 2550, so that no sum is below 0. */
  private static final int BIAS = 2560;

  /** Above 26520, the largest difference of two such sums of two, and a multiple of 4. */
  private static final long GAP_BIAS = Words.lanes(26624);

  /** What is left of the biases after dividing: ((26624 / 4 + 26624) / 4 + 2 * 2560) / 64. */
  private static final long CENTRE_BIAS = Words.lanes(210);

  private static final long PIXEL_BIAS = Words.lanes(BIAS / 32);

  private static final long TOP = 0x8000_8000_8000_8000L;

  private final byte[] second = new byte[Samples.BLUE];

  /** Sums along rows, of 16 rows and five more: two words of even and two of odd pixels a row. */
  private final long[] sums = new long[21 * 4];

  /**
   * Predicts 16 by 16 pixels of luma.
   *
   * @param x of the first one, in quarters of a pixel
   * @param y of the first one, in quarters of a pixel
   */
  void luma(Plane plane, int x, int y, Samples to) {
    int at = plane.at(x >> 2, y >> 2);
    int partX = x & 3;
    int partY = y & 3;
    int rightAt = partX == 3 ? at + 1 : at;
    int belowAt = partY == 3 ? at + plane.stride : at;
    byte[] first = to.bytes;
    if (partX == 0 && partY == 0) {
      copy(plane, at, first);
    } else if (partY == 0) {
      along(plane, at, first);
      if (partX != 2) {
        copy(plane, rightAt, second);
        average(first);
      }
    } else if (partX == 0) {
      across(plane, at, first);
      if (partY != 2) {
        copy(plane, belowAt, second);
        average(first);
      }
    } else {
      between(plane, at, x, y, first);
    }
  }

  /**
   * Predicts 8 by 8 pixels of one colour.
   *
   * @param x of the first one, in eighths of a pixel
   * @param y of the first one, in eighths of a pixel
   * @param at where they go
   */
  void colour(Plane plane, int x, int y, byte[] to, int at) {
    int right = x & 7;
    int down = y & 7;
    byte[] pixels = plane.bytes;
    int from = plane.at(x >> 3, y >> 3);
    if ((right | down) == 0) {
      for (int i = at; i < Samples.STRIDE * 24; i += STRIDE) {
        Words.put(to, i, Words.get(pixels, from));
        from += plane.stride;
      }
      return;
    }
    long here = Words.get(pixels, from);
    long beside = Words.get(pixels, from + 1);
    long even = eighths(even(here), even(beside), right);
    long odd = eighths(odd(here), odd(beside), right);
    for (int i = at; i < Samples.STRIDE * 24; i += STRIDE) {
      from += plane.stride;
      here = Words.get(pixels, from);
      beside = Words.get(pixels, from + 1);
      long evenBelow = eighths(even(here), even(beside), right);
      long oddBelow = eighths(odd(here), odd(beside), right);
      long evenSum = eighths(even, evenBelow, down);
      long oddSum = eighths(odd, oddBelow, down);
      Words.put(to, i, sixtyFourth(evenSum) | (sixtyFourth(oddSum) << 8));
      even = evenBelow;
      odd = oddBelow;
    }
  }

  /** Eight times what lies between two. */
  private static long eighths(long from, long to, int part) {
    return (from << 3) + (to - from) * part;
  }

  private static long sixtyFourth(long sums) {
    return ((sums + Words.lanes(32)) >>> 6) & Words.LANES;
  }

  private void between(Plane plane, int at, int x, int y, byte[] first) {
    int rightAt = (x & 3) == 3 ? at + 1 : at;
    int belowAt = (y & 3) == 3 ? at + plane.stride : at;
    if ((x & 1) != 0 && (y & 1) != 0) {
      along(plane, belowAt, first);
      across(plane, rightAt, second);
      average(first);
      return;
    }
    centre(plane, at, first);
    if ((y & 1) != 0) {
      alongFromSums((y & 3) == 3 ? 3 : 2, second);
      average(first);
    } else if ((x & 1) != 0) {
      across(plane, rightAt, second);
      average(first);
    }
  }

  private static void copy(Plane plane, int at, byte[] to) {
    int from = at;
    for (int i = 0; i < Samples.BLUE; i += STRIDE) {
      Words.put(to, i, Words.get(plane.bytes, from));
      Words.put(to, i + 8, Words.get(plane.bytes, from + 8));
      from += plane.stride;
    }
  }

  private void average(byte[] first) {
    for (int i = 0; i < Samples.BLUE; i += 8) {
      Words.put(first, i, Words.average(Words.get(first, i), Words.get(second, i)));
    }
  }

  /** Half a pixel to the right. */
  private static void along(Plane plane, int at, byte[] to) {
    byte[] pixels = plane.bytes;
    int row = at;
    for (int i = 0; i < Samples.BLUE; i += STRIDE) {
      for (int half = 0; half < STRIDE; half += 8) {
        int from = row + half;
        long before = Words.get(pixels, from - 2);
        long here = Words.get(pixels, from);
        long after = Words.get(pixels, from + 2);
        long last = even(Words.get(pixels, from + 4));
        long even =
            taps(even(before) + odd(after), odd(before) + even(after), even(here) + odd(here));
        long odd = taps(odd(before) + last, even(here) + odd(after), odd(here) + even(after));
        Words.put(to, i + half, cut(divide(even), divide(odd), PIXEL_BIAS));
      }
      row += plane.stride;
    }
  }

  /** Half a pixel down. */
  private static void across(Plane plane, int at, byte[] to) {
    byte[] pixels = plane.bytes;
    int stride = plane.stride;
    for (int half = 0; half < STRIDE; half += 8) {
      int from = at + half - 2 * stride;
      long a = Words.get(pixels, from);
      long b = Words.get(pixels, from + stride);
      long c = Words.get(pixels, from + 2 * stride);
      long d = Words.get(pixels, from + 3 * stride);
      long e = Words.get(pixels, from + 4 * stride);
      for (int i = half; i < Samples.BLUE; i += STRIDE) {
        long f = Words.get(pixels, from + 5 * stride);
        long even = taps(even(a) + even(f), even(b) + even(e), even(c) + even(d));
        long odd = taps(odd(a) + odd(f), odd(b) + odd(e), odd(c) + odd(d));
        Words.put(to, i, cut(divide(even), divide(odd), PIXEL_BIAS));
        from += stride;
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
      }
    }
  }

  /** Half a pixel to the right and down. */
  private void centre(Plane plane, int at, byte[] to) {
    sumsAlong(plane, at - 2 * plane.stride);
    for (int i = 0; i < 16; i++) {
      int row = 4 * i;
      for (int half = 0; half < 2; half++) {
        Words.put(
            to,
            STRIDE * i + 8 * half,
            cut(centre(row + half), centre(row + half + 2), CENTRE_BIAS));
      }
    }
  }

  /** Half a pixel to the right, where {@link #centre} has left its sums. */
  private void alongFromSums(int firstRow, byte[] to) {
    for (int i = 0; i < 16; i++) {
      int row = 4 * (i + firstRow);
      for (int half = 0; half < 2; half++) {
        long even = thirtySecond(sums[row + half]);
        long odd = thirtySecond(sums[row + half + 2]);
        Words.put(to, STRIDE * i + 8 * half, cut(even, odd, PIXEL_BIAS));
      }
    }
  }

  private void sumsAlong(Plane plane, int at) {
    byte[] pixels = plane.bytes;
    long bias = Words.lanes(BIAS);
    int row = at;
    for (int i = 0; i < sums.length; i += 4) {
      for (int half = 0; half < 2; half++) {
        int from = row + 8 * half;
        long before = Words.get(pixels, from - 2);
        long here = Words.get(pixels, from);
        long after = Words.get(pixels, from + 2);
        long last = even(Words.get(pixels, from + 4));
        sums[i + half] =
            bias
                + taps(
                    even(before) + odd(after), odd(before) + even(after), even(here) + odd(here));
        sums[i + half + 2] =
            bias + taps(odd(before) + last, even(here) + odd(after), odd(here) + even(after));
      }
      row += plane.stride;
    }
  }

  /**
   * The six taps over sums, divided by 1024, with a bias. As (outer - 5 middle + 20 inner) / 16 =
   * ((outer - middle) / 4 + (inner - middle)) / 4 + inner holds with each division rounded down,
   * lanes of 16 bits suffice; the second division halves first, since its sum alone could be too
   * large.
   */
  private long centre(int index) {
    long outer = sums[index] + sums[index + 20];
    long middle = sums[index + 4] + sums[index + 16];
    long inner = sums[index + 8] + sums[index + 12];
    long slope = ((outer + GAP_BIAS - middle) >>> 2) & Words.lanes(0x3FFF);
    long gap = inner + GAP_BIAS - middle;
    long half = (slope & gap) + (((slope ^ gap) >>> 1) & Words.lanes(0x7FFF));
    long sixteenth = ((half >>> 1) & Words.lanes(0x7FFF)) + inner;
    return ((sixteenth + Words.lanes(32)) >>> 6) & Words.lanes(0x03FF);
  }

  private static long even(long word) {
    return word & Words.LANES;
  }

  private static long odd(long word) {
    return (word >>> 8) & Words.LANES;
  }

  /** Outer - 5 middle + 20 inner. */
  private static long taps(long outer, long middle, long inner) {
    long four = (inner << 2) - middle;
    return outer + (four << 2) + four;
  }

  /** Divides sums by 32; they have their bias then. */
  private static long divide(long sums) {
    return thirtySecond(sums + Words.lanes(BIAS));
  }

  private static long thirtySecond(long biased) {
    return ((biased + Words.lanes(16)) >>> 5) & Words.lanes(0x07FF);
  }

  /** Puts even and odd lanes together. */
  private static long cut(long even, long odd, long bias) {
    long evenBytes = even - bias;
    long oddBytes = odd - bias;
    if (((evenBytes | oddBytes) & ~Words.LANES) != 0) {
      return clip(even, bias) | (clip(odd, bias) << 8);
    }
    return evenBytes | (oddBytes << 8);
  }

  /** Takes the bias off and brings all between 0 and 255; without the bias they are below 512. */
  private static long clip(long biased, long bias) {
    long signed = (biased | TOP) - bias;
    long positive = (signed >>> 15) & Words.lanes(1);
    long atLeastZero = signed & ((positive << 16) - positive) & ~TOP;
    long over = (atLeastZero >>> 8) & Words.lanes(1);
    return (atLeastZero | ((over << 8) - over)) & Words.LANES;
  }
}
