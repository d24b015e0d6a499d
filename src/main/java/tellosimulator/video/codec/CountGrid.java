package tellosimulator.video.codec;

/**
 * How many levels each block of one plane has; what is likely in a block depends on those beside.
 */
final class CountGrid {

  private final byte[] counts;
  private final int columns;

  CountGrid(int columns, int rows) {
    this.columns = columns;
    counts = new byte[columns * rows];
  }

  void set(int column, int row, int count) {
    counts[row * columns + column] = (byte) count;
  }

  /** The mean of the blocks at the left and above, as far as there are any. */
  int context(int column, int row) {
    int at = row * columns + column;
    if (column == 0) {
      return row == 0 ? 0 : counts[at - columns];
    }
    if (row == 0) {
      return counts[at - 1];
    }
    return (counts[at - 1] + counts[at - columns] + 1) >> 1;
  }
}
