package tellosimulator.time;

/**
 * A moment of simulated time, counted from the start of the simulation.
 *
 * @param nanos nanoseconds, never negative
 */
public record SimTime(long nanos) implements Comparable<SimTime> {

  public static final SimTime ZERO = new SimTime(0);

  /** Length of a simulation step [ns]. */
  public static final long STEP_NANOS = 5_000_000;

  /** Length of a simulation step [s]. */
  public static final double STEP = STEP_NANOS * 1e-9;

  public SimTime {
    if (nanos < 0) {
      throw new IllegalArgumentException("nanos is " + nanos + ", but must be 0 or more");
    }
  }

  /** Returns the moment one step later. */
  public SimTime next() {
    return new SimTime(nanos + STEP_NANOS);
  }

  /** Returns the moment that is {@code seconds} later. */
  public SimTime plus(double seconds) {
    return new SimTime(nanos + Math.round(seconds * 1e9));
  }

  public double seconds() {
    return nanos * 1e-9;
  }

  /**
   * Returns the seconds from {@code earlier} to this moment; negative if {@code earlier} is later.
   */
  public double since(SimTime earlier) {
    return (nanos - earlier.nanos) * 1e-9;
  }

  public boolean isBefore(SimTime other) {
    return nanos < other.nanos;
  }

  @Override
  public int compareTo(SimTime other) {
    return Long.compare(nanos, other.nanos);
  }
}
