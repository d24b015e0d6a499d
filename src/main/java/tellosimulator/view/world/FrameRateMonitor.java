package tellosimulator.view.world;

/**
 * Monitors whether the scene is rendered smoothly while something moves. Pauses between frames do
 * not count, because an idle window draws rarely. The first seconds do not count either, because
 * code is still being compiled. Not thread-safe.
 */
final class FrameRateMonitor {

  /** Lowest frame rate that counts as smooth [1/s]. Decided: the frame rate of cinema films. */
  static final double LEAST_RATE = 24;

  /** Duration of movement before the first measurement [ns]. Decided. */
  static final long WARM_UP = 6_000_000_000L;

  /** Duration of a measurement [ns]. Decided: longer than any single disturbance. */
  static final long PERIOD = 5_000_000_000L;

  /**
   * Minimum time between two frames that counts as a pause [ns]. Decided: shorter than the interval
   * between the ticks of an idle window.
   */
  private static final long PAUSE = 450_000_000;

  private static final double NANOS_PER_SECOND = 1e9;

  private long last = Long.MIN_VALUE;
  private long moved;
  private long watched;
  private int frames;
  private boolean jerky;

  /**
   * Counts a frame that is shown.
   *
   * @param nanos the time of any monotonic clock [ns]
   */
  void frame(long nanos) {
    long passed = last == Long.MIN_VALUE ? PAUSE : nanos - last;
    last = nanos;
    if (passed >= PAUSE) {
      return;
    }
    moved += passed;
    if (moved < WARM_UP) {
      return;
    }
    watched += passed;
    frames++;
    if (watched >= PERIOD) {
      jerky = frames * NANOS_PER_SECOND / watched < LEAST_RATE;
      watched = 0;
      frames = 0;
    }
  }

  /** Returns whether the last measurement was below {@link #LEAST_RATE}. */
  boolean jerky() {
    return jerky;
  }

  /** Restarts the measurement with another warm-up. */
  void restart() {
    moved = 0;
    watched = 0;
    frames = 0;
    jerky = false;
  }
}
