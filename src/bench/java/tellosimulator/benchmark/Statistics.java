package tellosimulator.benchmark;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;

/** Some numbers, looked at together. */
public final class Statistics {

  private final double[] sorted;

  public Statistics(Collection<Double> values) {
    sorted = values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
  }

  static Statistics of(Double... values) {
    return new Statistics(List.of(values));
  }

  /**
   * The value below which a share of all values lies.
   *
   * @param share 0 to 1
   */
  public double quantile(double share) {
    return sorted[(int) Math.round(share * (sorted.length - 1))];
  }

  public double median() {
    return quantile(0.5);
  }

  public double mean() {
    return Arrays.stream(sorted).average().orElse(Double.NaN);
  }

  public double deviation() {
    double mean = mean();
    return Math.sqrt(Arrays.stream(sorted).map(v -> (v - mean) * (v - mean)).average().orElse(0));
  }
}
