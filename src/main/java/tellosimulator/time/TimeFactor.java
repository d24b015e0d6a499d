package tellosimulator.time;

/**
 * The number of simulated seconds per second of wall clock time.
 *
 * @param value the factor; must be positive; infinite for as fast as the machine allows
 */
public record TimeFactor(double value) {

  public static final TimeFactor REAL_TIME = new TimeFactor(1);

  /**
   * As fast as the machine allows while something moves; otherwise, simulated time stands still.
   */
  public static final TimeFactor MAX = new TimeFactor(Double.POSITIVE_INFINITY);

  /** The smallest factor: a step takes half a second. */
  public static final double SMALLEST = 0.01;

  /** The largest finite factor: a step takes a microsecond. No machine is that fast. */
  public static final double LARGEST = 5000;

  public TimeFactor {
    boolean finite = value >= SMALLEST && value <= LARGEST;
    if (!finite && value != Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "time factor is "
              + value
              + ", but must be from "
              + SMALLEST
              + " to "
              + LARGEST
              + ", or max");
    }
  }

  public boolean unlimited() {
    return value == Double.POSITIVE_INFINITY;
  }

  @Override
  public String toString() {
    return unlimited() ? "max" : Double.toString(value);
  }
}
