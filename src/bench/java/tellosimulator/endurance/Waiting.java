package tellosimulator.endurance;

import java.util.concurrent.locks.LockSupport;

/** Time that passes while others act. */
final class Waiting {

  /** Between two looks at something that changes [s]. */
  static final double SHORT = 0.01;

  private static final long LONGEST = 100_000_000;

  private Waiting() {}

  static void pass(double seconds) {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
      LockSupport.parkNanos(Math.min(left, LONGEST));
    }
  }
}
