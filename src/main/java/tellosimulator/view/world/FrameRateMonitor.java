package tellosimulator.view.world;

/**
 * Monitors whether a picture is fluent while something moves in it. Pauses between frames, as those
 * of an idle window, do not count, nor do the first seconds, in which code is still compiled. For
 * one thread.
 */
final class FrameRateMonitor {

  /** Fewest frames a second of a fluent picture. Decided: those of films. */
  static final double LEAST_RATE = 24;

  /** Time of movement before it is judged [ns]. Decided. */
  static final long WARM_UP = 6_000_000_000L;

  /** How long it is watched for a judgement [ns]. Decided: longer than anything that disturbs. */
  static final long PERIOD = 5_000_000_000L;

  /**
   * No frame for this long is a pause [ns]. Decided: less than between frames of an idle window.
   */
  private static final long PAUSE = 450_000_000;

  private static final double NANOS_PER_SECOND = 1e9;

  private long last = Long.MIN_VALUE;
  private long moved;
  private long watched;
  private int frames;
  private boolean jerky;

  /**
   * A frame is shown.
   *
   * @param nanos of any steady clock [ns]
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

  /** Whether the picture was not fluent when it was judged last. */
  boolean jerky() {
    return jerky;
  }

  /** Judges anew, after another warm-up. */
  void restart() {
    moved = 0;
    watched = 0;
    frames = 0;
    jerky = false;
  }
}
