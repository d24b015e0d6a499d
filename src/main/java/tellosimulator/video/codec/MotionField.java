package tellosimulator.video.codec;

/**
 * The motion vectors of a picture's macroblocks, in quarters of a pixel, and those of the picture
 * before. A macroblock's vector is expected from those at the left, above and above right.
 */
final class MotionField {

  final int columns;
  private int[] vectorsX;
  private int[] vectorsY;
  private boolean[] moved;
  private int[] earlierX;
  private int[] earlierY;

  /** The vector from which a macroblock tells its difference; after {@link #expect}. */
  int expectedX;

  int expectedY;

  /** The vector of a skipped macroblock; after {@link #expect}. */
  int skipX;

  int skipY;

  MotionField(int columns, int rows) {
    this.columns = columns;
    int macroblocks = columns * rows;
    vectorsX = new int[macroblocks];
    vectorsY = new int[macroblocks];
    moved = new boolean[macroblocks];
    earlierX = new int[macroblocks];
    earlierY = new int[macroblocks];
  }

  /** Begins a picture; what was this picture is now the one before. */
  void next() {
    int[] swap = vectorsX;
    vectorsX = earlierX;
    earlierX = swap;
    swap = vectorsY;
    vectorsY = earlierY;
    earlierY = swap;
  }

  /** A macroblock that is predicted from another picture. */
  void set(int index, int x, int y) {
    vectorsX[index] = x;
    vectorsY[index] = y;
    moved[index] = true;
  }

  /** A macroblock that is predicted from the same picture; its vector counts as 0. */
  void setIntra(int index) {
    vectorsX[index] = 0;
    vectorsY[index] = 0;
    moved[index] = false;
  }

  int x(int index) {
    return vectorsX[index];
  }

  int y(int index) {
    return vectorsY[index];
  }

  int earlierX(int index) {
    return earlierX[index];
  }

  int earlierY(int index) {
    return earlierY[index];
  }

  /** Finds what is expected of a macroblock (H.264, 8.4.1.1 and 8.4.1.3). */
  void expect(int column, int row) {
    int index = row * columns + column;
    int left = column > 0 ? index - 1 : -1;
    int above = row > 0 ? index - columns : -1;
    expect(left, above, corner(column, row));
    boolean still = left < 0 || above < 0 || still(left) || still(above);
    skipX = still ? 0 : expectedX;
    skipY = still ? 0 : expectedY;
  }

  /** Above right; above left where there is none. */
  private int corner(int column, int row) {
    if (row == 0) {
      return -1;
    }
    int above = (row - 1) * columns + column;
    return column + 1 < columns ? above + 1 : column > 0 ? above - 1 : -1;
  }

  private void expect(int left, int above, int corner) {
    boolean leftMoved = left >= 0 && moved[left];
    boolean aboveMoved = above >= 0 && moved[above];
    boolean cornerMoved = corner >= 0 && moved[corner];
    int only =
        above < 0 && corner < 0
            ? left
            : leftMoved && !aboveMoved && !cornerMoved
                ? left
                : aboveMoved && !leftMoved && !cornerMoved
                    ? above
                    : cornerMoved && !leftMoved && !aboveMoved ? corner : -1;
    if (only >= 0) {
      expectedX = vectorsX[only];
      expectedY = vectorsY[only];
    } else {
      expectedX = median(at(vectorsX, left), at(vectorsX, above), at(vectorsX, corner));
      expectedY = median(at(vectorsY, left), at(vectorsY, above), at(vectorsY, corner));
    }
  }

  private boolean still(int index) {
    return moved[index] && vectorsX[index] == 0 && vectorsY[index] == 0;
  }

  private static int at(int[] vectors, int index) {
    return index < 0 ? 0 : vectors[index];
  }

  private static int median(int a, int b, int c) {
    return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
  }
}
