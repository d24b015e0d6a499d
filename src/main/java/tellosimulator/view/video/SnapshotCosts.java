package tellosimulator.view.video;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Whether pictures of the window's scene are cheap: by the median of what the last ones cost on the
 * JavaFX thread. With a graphics card they are; without one the software camera is cheaper, and
 * runs on another thread. For one thread at a time.
 */
final class SnapshotCosts {

  /** Most that a picture may cost [ns]. Decided: half of a frame of the window. */
  static final long LIMIT = 8_000_000;

  /** How many pictures say something. Decided: one of them may be an exception. */
  static final int FEWEST = 3;

  /** How many pictures count. Decided: half a second of a stream. */
  static final int MOST = 15;

  private final Deque<Long> costs = new ArrayDeque<>();

  /**
   * A picture was taken.
   *
   * @param cost time that it took [ns]
   */
  void add(long cost) {
    if (costs.size() == MOST) {
      costs.removeFirst();
    }
    costs.addLast(cost);
  }

  /** Forgets all pictures; the next ones decide anew. */
  void forget() {
    costs.clear();
  }

  /** Whether enough pictures were taken to know. */
  boolean known() {
    return costs.size() >= FEWEST;
  }

  /** Whether it is known that they are cheap. */
  boolean cheap() {
    return known() && median() <= LIMIT;
  }

  /** What they cost [ns]; 0 if there was none. */
  long median() {
    if (costs.isEmpty()) {
      return 0;
    }
    long[] sorted = costs.stream().mapToLong(Long::longValue).sorted().toArray();
    return sorted[sorted.length / 2];
  }
}
