package tellosimulator.video;

/**
 * Counts the FAST-9 corners (Rosten and Drummond 2006) in an image pyramid, with the parameters of
 * OpenCV's {@code ORB_create}: 8 levels, each smaller by a factor of 1.2, a threshold of 20, and a
 * margin of 31 pixels at each level. A corner has the highest score of the nine pixels around it.
 */
final class FastCorners {

  private static final int LEVELS = 8;
  private static final double SCALE = 1.2;
  private static final int MARGIN = 31;
  private static final int THRESHOLD = 20;
  private static final int ARC = 9;

  /** The circle around a pixel, clockwise from the top. */
  private static final int[] CIRCLE_X = {0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};

  private static final int[] CIRCLE_Y = {-3, -3, -2, -1, 0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3};

  private final int width;
  private final int height;
  private final int[] luma;

  /**
   * Creates a level.
   *
   * @param luma full-range luma, row by row
   */
  FastCorners(int width, int height, int[] luma) {
    this.width = width;
    this.height = height;
    this.luma = luma;
  }

  /** Returns the number of corners in all levels of the pyramid. */
  int count() {
    int count = 0;
    for (int level = 0; level < LEVELS; level++) {
      count += resized(StrictMath.pow(SCALE, level)).corners();
    }
    return count;
  }

  /** Resizes by the mean of the pixels that each new pixel covers. */
  private FastCorners resized(double factor) {
    int newWidth = (int) Math.round(width / factor);
    int newHeight = (int) Math.round(height / factor);
    int[] resized = new int[newWidth * newHeight];
    for (int y = 0; y < newHeight; y++) {
      for (int x = 0; x < newWidth; x++) {
        resized[y * newWidth + x] = mean(x * factor, y * factor, factor);
      }
    }
    return new FastCorners(newWidth, newHeight, resized);
  }

  private int mean(double left, double top, double size) {
    double sum = 0;
    double covered = 0;
    for (int y = (int) top; y < Math.min(height, top + size); y++) {
      for (int x = (int) left; x < Math.min(width, left + size); x++) {
        double weight =
            (Math.min(y + 1, top + size) - Math.max(y, top))
                * (Math.min(x + 1, left + size) - Math.max(x, left));
        sum += weight * luma[y * width + x];
        covered += weight;
      }
    }
    return (int) Math.round(sum / covered);
  }

  private int corners() {
    int[] scores = new int[luma.length];
    for (int y = MARGIN - 1; y <= height - MARGIN; y++) {
      for (int x = MARGIN - 1; x <= width - MARGIN; x++) {
        scores[y * width + x] = score(x, y);
      }
    }
    int corners = 0;
    for (int y = MARGIN; y < height - MARGIN; y++) {
      for (int x = MARGIN; x < width - MARGIN; x++) {
        if (scores[y * width + x] > THRESHOLD && isHighest(scores, y * width + x)) {
          corners++;
        }
      }
    }
    return corners;
  }

  private boolean isHighest(int[] scores, int at) {
    for (int row = -width; row <= width; row += width) {
      for (int i = at + row - 1; i <= at + row + 1; i++) {
        if (i != at && scores[i] >= scores[at]) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns the largest contrast with which an arc of the circle is all darker or all lighter. */
  private int score(int x, int y) {
    int score = 0;
    for (int start = 0; start < CIRCLE_X.length; start++) {
      int lighter = Integer.MAX_VALUE;
      int darker = Integer.MAX_VALUE;
      for (int i = start; i < start + ARC; i++) {
        int at = i % CIRCLE_X.length;
        int contrast = luma[(y + CIRCLE_Y[at]) * width + x + CIRCLE_X[at]] - luma[y * width + x];
        lighter = Math.min(lighter, contrast);
        darker = Math.min(darker, -contrast);
      }
      score = Math.max(score, Math.max(lighter, darker));
    }
    return score;
  }
}
