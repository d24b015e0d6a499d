package tellosimulator.view.app;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import javafx.animation.AnimationTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Logs the time from the program's start until the window is usable, and then the frame rate every
 * ten seconds, both at level debug. Benchmarks parse these lines. Confined to the JavaFX thread.
 */
final class FrameRateLog extends AnimationTimer {

  private static final Logger LOG = LoggerFactory.getLogger(FrameRateLog.class);

  /**
   * The number of the pulse, from 1, at which the first frame counts as shown. The first pulse lays
   * out the window and submits a frame to the renderer; the second begins once the renderer has
   * accepted that frame.
   */
  private static final int FIRST_SHOWN = 2;

  private static final double PERIOD_NANOS = 10e9;
  private static final double NANOS_PER_SECOND = 1e9;

  private long frames;
  private long sinceNanos;

  private FrameRateLog() {}

  /**
   * Starts logging if level debug is enabled. Must be called right after the window has been shown.
   */
  static void begin() {
    if (LOG.isDebugEnabled()) {
      new FrameRateLog().start();
    }
  }

  @Override
  public void handle(long nanos) {
    frames++;
    if (sinceNanos == 0 && frames == FIRST_SHOWN) {
      long start = ManagementFactory.getRuntimeMXBean().getStartTime();
      LOG.debug(
          "The window can be used, {} ms after the start", System.currentTimeMillis() - start);
      restart(nanos);
    } else if (sinceNanos != 0 && nanos - sinceNanos > PERIOD_NANOS) {
      double rate = frames * NANOS_PER_SECOND / (nanos - sinceNanos);
      LOG.debug("{} frames a second", String.format(Locale.ROOT, "%.1f", rate));
      restart(nanos);
    }
  }

  private void restart(long nanos) {
    frames = 0;
    sinceNanos = nanos;
  }
}
