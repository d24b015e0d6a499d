package tellosimulator.report;

import java.util.List;
import java.util.StringJoiner;
import java.util.function.ToDoubleFunction;
import tellosimulator.recording.Sample;

/** Writes samples as columns, which are short and quickly read: {@code 0 1.5 3}. */
final class Column {

  private static final double[] POWERS = {1, 10, 100, 1000};

  private Column() {}

  /**
   * A column.
   *
   * @param decimals how many, 0 to 3
   */
  static String of(List<Sample> samples, int decimals, ToDoubleFunction<Sample> value) {
    StringJoiner column = new StringJoiner(" ");
    for (Sample sample : samples) {
      column.add(figure(value.applyAsDouble(sample), decimals));
    }
    return column.toString();
  }

  /** A number with so many decimals, without zeros at its end. */
  static String figure(double value, int decimals) {
    double rounded = Math.round(value * POWERS[decimals]) / POWERS[decimals];
    return rounded == Math.rint(rounded) ? Long.toString((long) rounded) : Double.toString(rounded);
  }
}
