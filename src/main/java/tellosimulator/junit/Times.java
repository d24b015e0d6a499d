package tellosimulator.junit;

/**
 * How often a command is expected in a {@link Journal}. Immutable.
 *
 * @param least the minimum number of occurrences
 * @param most the maximum number of occurrences
 */
public record Times(int least, int most) {

  public Times {
    if (least < 0 || most < least) {
      throw new IllegalArgumentException(
          "times are from " + least + " to " + most + ", but must be from 0 up, in rising order");
    }
  }

  /** Expects exactly a given number of occurrences. */
  public static Times times(int count) {
    return new Times(count, count);
  }

  /** Expects at least a given number of occurrences. */
  public static Times atLeast(int count) {
    return new Times(count, Integer.MAX_VALUE);
  }

  /** Expects at most a given number of occurrences. */
  public static Times atMost(int count) {
    return new Times(0, count);
  }

  boolean holds(int count) {
    return count >= least && count <= most;
  }

  @Override
  public String toString() {
    String count = least == most || least > 0 ? Integer.toString(least) : Integer.toString(most);
    String prefix = least == most ? "" : least > 0 ? "at least " : "at most ";
    return prefix + count + (count.equals("1") ? " time" : " times");
  }
}
