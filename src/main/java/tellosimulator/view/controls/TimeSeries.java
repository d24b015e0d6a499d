package tellosimulator.view.controls;

/**
 * The newest samples of a value, with their moments; the oldest make room for new ones.
 *
 * <p>Keeps {@link #SPAN} seconds of simulated time, at most four samples a second, so that its size
 * depends neither on the frame rate nor on how fast time passes.
 */
final class TimeSeries {

  /** How far back it reaches [s]. */
  static final double SPAN = 60;

  /** Least time between two samples [s]. Decided: finer than a pixel of a small chart. */
  static final double PERIOD = 0.25;

  /** One sample more than fits, which is beyond the left edge. */
  private static final int CAPACITY = (int) (SPAN / PERIOD) + 2;

  private final double[] times = new double[CAPACITY];
  private final double[] values = new double[CAPACITY];
  private int first;
  private int size;

  /**
   * Takes a value, if the last one is old enough.
   *
   * @param seconds simulated time [s]; time that went back starts anew
   */
  void add(double seconds, double value) {
    if (size > 0) {
      double since = seconds - time(size - 1);
      if (since < 0) {
        size = 0;
      } else if (since < PERIOD) {
        return;
      }
    }
    if (size == CAPACITY) {
      first = (first + 1) % CAPACITY;
      size--;
    }
    int place = (first + size) % CAPACITY;
    times[place] = seconds;
    values[place] = value;
    size++;
  }

  int size() {
    return size;
  }

  /** Moment of a sample [s]; 0 is the oldest. */
  double time(int index) {
    return times[(first + index) % CAPACITY];
  }

  /** A sample; 0 is the oldest. */
  double value(int index) {
    return values[(first + index) % CAPACITY];
  }

  /** The largest sample that is not older than {@link #SPAN}, 0 if there is none above. */
  double largest(double nowSeconds) {
    double largest = 0;
    for (int i = 0; i < size; i++) {
      if (time(i) >= nowSeconds - SPAN) {
        largest = Math.max(largest, value(i));
      }
    }
    return largest;
  }
}
