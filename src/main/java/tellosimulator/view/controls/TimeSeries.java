package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;

/**
 * The newest samples of a value, with their times.
 *
 * <p>The series covers {@link #SPAN} seconds of simulated time with at most four samples a second,
 * so that its size depends neither on the frame rate nor on the speed of time.
 */
final class TimeSeries {

  /** The time that the series covers [s]. */
  static final double SPAN = 60;

  /** Minimum time between two samples [s]. Decided: less than a pixel of a small chart. */
  static final double PERIOD = 0.25;

  /**
   * Maximum number of samples. The span contains one more sample than periods, and another sample
   * lies beyond the left edge.
   */
  private static final int CAPACITY = (int) (SPAN / PERIOD) + 2;

  private record Sample(double seconds, double value) {}

  private final List<Sample> samples = new ArrayList<>();

  /**
   * Adds a value, unless the last one is too recent.
   *
   * @param seconds the simulated time [s]; if it has gone back, the series starts again
   */
  void add(double seconds, double value) {
    double since = samples.isEmpty() ? PERIOD : seconds - time(size() - 1);
    if (since < 0) {
      samples.clear();
    } else if (since < PERIOD) {
      return;
    }
    if (size() == CAPACITY) {
      samples.remove(0);
    }
    samples.add(new Sample(seconds, value));
  }

  int size() {
    return samples.size();
  }

  /** Returns the time of a sample [s]; 0 is the oldest. */
  double time(int index) {
    return samples.get(index).seconds();
  }

  /** Returns a sample; 0 is the oldest. */
  double value(int index) {
    return samples.get(index).value();
  }

  /** Returns the largest sample that is not older than {@link #SPAN}, but at least 0. */
  double largest(double nowSeconds) {
    return samples.stream()
        .filter(sample -> sample.seconds() >= nowSeconds - SPAN)
        .mapToDouble(Sample::value)
        .reduce(0, Math::max);
  }
}
