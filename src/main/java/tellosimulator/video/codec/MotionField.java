package tellosimulator.video.codec;

/**
 * The motion vectors of the current and the previous frame, one for each macroblock [quarter
 * samples]. This class also predicts motion vectors from the neighbours A (left), B (above) and C
 * (above right).
 */
final class MotionField {

  final int widthInMbs;
  private int[] mvX;
  private int[] mvY;
  private int[] previousMvX;
  private int[] previousMvY;

  /** Whether each macroblock is inter coded. Only such macroblocks have a motion vector. */
  private final boolean[] inter;

  /** The horizontal component of the predicted motion vector; valid after {@link #predictMv}. */
  int mvpX;

  /** The vertical component of the predicted motion vector; valid after {@link #predictMv}. */
  int mvpY;

  /** The horizontal component of the P_Skip motion vector; valid after {@link #predictMv}. */
  int pSkipMvX;

  /** The vertical component of the P_Skip motion vector; valid after {@link #predictMv}. */
  int pSkipMvY;

  MotionField(int widthInMbs, int heightInMbs) {
    this.widthInMbs = widthInMbs;
    int macroblocks = widthInMbs * heightInMbs;
    mvX = new int[macroblocks];
    mvY = new int[macroblocks];
    inter = new boolean[macroblocks];
    previousMvX = new int[macroblocks];
    previousMvY = new int[macroblocks];
  }

  /** Begins a frame. The vectors of the current frame become the vectors of the previous frame. */
  void beginFrame() {
    int[] swap = mvX;
    mvX = previousMvX;
    previousMvX = swap;
    swap = mvY;
    mvY = previousMvY;
    previousMvY = swap;
  }

  /** Stores the vector of an inter macroblock. */
  void set(int mbIndex, int x, int y) {
    mvX[mbIndex] = x;
    mvY[mbIndex] = y;
    inter[mbIndex] = true;
  }

  /** Marks a macroblock as intra coded; its vector counts as zero. */
  void setIntra(int mbIndex) {
    mvX[mbIndex] = 0;
    mvY[mbIndex] = 0;
    inter[mbIndex] = false;
  }

  int mvX(int mbIndex) {
    return mvX[mbIndex];
  }

  int mvY(int mbIndex) {
    return mvY[mbIndex];
  }

  int previousMvX(int mbIndex) {
    return previousMvX[mbIndex];
  }

  int previousMvY(int mbIndex) {
    return previousMvY[mbIndex];
  }

  /** Computes mvp and the P_Skip vector for a macroblock (H.264, 8.4.1.1 and 8.4.1.3). */
  void predictMv(int mbX, int mbY) {
    int mbIndex = mbY * widthInMbs + mbX;
    int a = mbX > 0 ? mbIndex - 1 : -1;
    int b = mbY > 0 ? mbIndex - widthInMbs : -1;
    predictMv(a, b, neighborC(mbX, mbY));
    boolean zero = a < 0 || b < 0 || isZero(a) || isZero(b);
    pSkipMvX = zero ? 0 : mvpX;
    pSkipMvY = zero ? 0 : mvpY;
  }

  /**
   * Returns the index of the neighbour C (above right), or of D (above left) if C is not available;
   * -1 if neither is available.
   */
  private int neighborC(int mbX, int mbY) {
    if (mbY == 0) {
      return -1;
    }
    int b = (mbY - 1) * widthInMbs + mbX;
    return mbX + 1 < widthInMbs ? b + 1 : mbX > 0 ? b - 1 : -1;
  }

  private void predictMv(int a, int b, int c) {
    boolean interA = a >= 0 && inter[a];
    boolean interB = b >= 0 && inter[b];
    boolean interC = c >= 0 && inter[c];
    int only =
        b < 0 && c < 0
            ? a
            : interA && !interB && !interC
                ? a
                : interB && !interA && !interC ? b : interC && !interA && !interB ? c : -1;
    if (only >= 0) {
      mvpX = mvX[only];
      mvpY = mvY[only];
    } else {
      mvpX = median(component(mvX, a), component(mvX, b), component(mvX, c));
      mvpY = median(component(mvY, a), component(mvY, b), component(mvY, c));
    }
  }

  private boolean isZero(int mbIndex) {
    return inter[mbIndex] && mvX[mbIndex] == 0 && mvY[mbIndex] == 0;
  }

  /** Returns a component of a neighbour's vector; zero if the neighbour is not available. */
  private static int component(int[] components, int mbIndex) {
    return mbIndex < 0 ? 0 : components[mbIndex];
  }

  private static int median(int a, int b, int c) {
    return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
  }
}
