package tellosimulator.video.codec;

import java.util.stream.IntStream;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.common.io.VLC;

/**
 * Writes the levels of blocks (CAVLC, H.264, 9.2) with JCodec's code tables. JCodec's own writer
 * makes arrays for each block.
 */
final class LevelWriter {

  /** Contexts from here on share a table. */
  private static final int LAST_CONTEXT = 8;

  /** The context of first levels of colour; other contexts are at most 16. */
  static final int COLOUR_FIRST = 17;

  /** The number of levels and of ones at the end, by context. */
  private static final int[][] TOKENS = tokens();

  /** The number of zeros before the last level, by number of levels less one. */
  private static final int[][] ZEROS = codes(H264Const.totalZeros16);

  /** The same for blocks of four. */
  private static final int[][] ZEROS_OF_FOUR = codes(H264Const.totalZeros4);

  /** The number of zeros before a level, by number of zeros that are left less one. */
  private static final int[][] RUNS = codes(H264Const.run);

  private static final int LENGTH_SHIFT = 16;

  private static final int[] ZIGZAG = IntStream.range(0, 16).map(Quantizer::place).toArray();
  private static final int[] STRAIGHT = IntStream.range(0, 16).toArray();

  private final BitWriter bits;
  private final int[] values = new int[16];
  private final int[] places = new int[16];

  LevelWriter(BitWriter bits) {
    this.bits = bits;
  }

  private static int[][] tokens() {
    int[][] all = new int[COLOUR_FIRST + 1][];
    for (int context = 0; context < COLOUR_FIRST; context++) {
      all[context] = codes(H264Const.CoeffToken[Math.min(context, LAST_CONTEXT)]);
    }
    all[COLOUR_FIRST] = codes(H264Const.coeffTokenChromaDCY420);
    return all;
  }

  private static int[][] codes(VLC[] tables) {
    int[][] all = new int[tables.length][];
    for (int i = 0; i < tables.length; i++) {
      all[i] = codes(tables[i]);
    }
    return all;
  }

  /** A code in the lower half, its length in the upper one. */
  private static int[] codes(VLC table) {
    int[] codes = new int[table.getCodes().length];
    for (int i = 0; i < codes.length; i++) {
      int length = table.getCodeSizes()[i];
      codes[i] = (length << LENGTH_SHIFT) | (table.getCodes()[i] >>> (Integer.SIZE - length));
    }
    return codes;
  }

  /** Writes a block without levels. */
  void none(int context) {
    put(TOKENS[context], 0);
  }

  /** Writes first levels, which are in the order in which they are written. */
  void firsts(int[] levels, int offset, int length, int context) {
    int mask = 0;
    for (int i = 0; i < length; i++) {
      mask |= (-Math.abs(levels[offset + i]) >>> 31) << i;
    }
    if (mask == 0) {
      none(context);
      return;
    }
    collect(levels, offset, mask, STRAIGHT);
    write(mask, length, context);
  }

  /**
   * Writes a block.
   *
   * @param levels its levels, from offset on
   * @param mask which of them are not 0, a bit each in zigzag order; there is one
   * @param length how many of them are written: 16, or 15 without the first
   * @param context the mean number of levels in the blocks beside
   */
  void block(int[] levels, int offset, int mask, int length, int context) {
    collect(levels, offset, mask, ZIGZAG);
    write(mask >>> (16 - length), length, context);
  }

  /**
   * Gathers what is not 0, last one first.
   *
   * @param order where the level is that each bit of the mask stands for
   */
  private void collect(int[] levels, int offset, int mask, int[] order) {
    int total = 0;
    for (int left = mask; left != 0; total++) {
      int place = 31 - Integer.numberOfLeadingZeros(left);
      values[total] = levels[offset + order[place]];
      places[total] = place;
      left ^= 1 << place;
    }
  }

  /**
   * Writes what was gathered.
   *
   * @param mask where it is among as many as the length says
   */
  private void write(int mask, int length, int context) {
    int total = Integer.bitCount(mask);
    int ones = 0;
    int signs = 0;
    while (ones < total && ones < 3 && Math.abs(values[ones]) == 1) {
      signs = 2 * signs + (values[ones] >>> 31);
      ones++;
    }
    int token = TOKENS[context][token(total, ones)];
    bits.put((code(token) << ones) | signs, length(token) + ones);
    levels(total, ones);
    int zeros = 32 - Integer.numberOfLeadingZeros(mask) - total;
    if (total < length) {
      put((length == 4 ? ZEROS_OF_FOUR : ZEROS)[total - 1], zeros);
    }
    runs(total, zeros);
  }

  /** A token's number in JCodec's tables: by levels, then by ones. */
  private static int token(int total, int ones) {
    return switch (total) {
      case 0 -> 0;
      case 1 -> 1 + ones;
      case 2 -> 3 + ones;
      default -> 4 * total - 6 + ones;
    };
  }

  private void levels(int total, int ones) {
    int suffix = total > 10 && ones < 3 ? 1 : 0;
    for (int i = ones; i < total; i++) {
      int magnitude = Math.abs(values[i]);
      int code = 2 * magnitude - 2 + (values[i] >>> 31);
      level(i == ones && ones < 3 ? code - 2 : code, suffix);
      if (suffix == 0) {
        suffix = 1;
      }
      if (magnitude > 3 << (suffix - 1) && suffix < 6) {
        suffix++;
      }
    }
  }

  private void level(int code, int suffix) {
    if (suffix == 0 && code < 14) {
      bits.put(1, code + 1);
    } else if (suffix == 0 && code < 30) {
      bits.put(1, 15);
      bits.put(code - 14, 4);
    } else if (suffix > 0 && code < (15 << suffix)) {
      bits.put(1, (code >> suffix) + 1);
      bits.put(code & ((1 << suffix) - 1), suffix);
    } else {
      bits.put(1, 16);
      bits.put(code - Math.max(30, 15 << suffix), 12);
    }
  }

  private void runs(int total, int zeros) {
    int left = zeros;
    for (int i = 0; i < total - 1 && left > 0; i++) {
      int run = places[i] - places[i + 1] - 1;
      put(RUNS[Math.min(left, 7) - 1], run);
      left -= run;
    }
  }

  private void put(int[] table, int index) {
    bits.put(code(table[index]), length(table[index]));
  }

  private static int code(int entry) {
    return entry & ((1 << LENGTH_SHIFT) - 1);
  }

  private static int length(int entry) {
    return entry >> LENGTH_SHIFT;
  }
}
