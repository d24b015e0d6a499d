package tellosimulator.view.app;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import javafx.animation.AnimationTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Notes in the log, level debug, when the window can be used and then every ten seconds how many
 * frames a second it shows. Benchmarks read it. For the JavaFX thread.
 */
final class FrameRateLog extends AnimationTimer {

  private static final Logger LOG = LoggerFactory.getLogger(FrameRateLog.class);

  /** The first pulse lays out and hands over a frame, the second one begins when it was taken. */
  private static final int FIRST_SHOWN = 2;

  private static final double PERIOD_NANOS = 10e9;
  private static final double NANOS_PER_SECOND = 1e9;

  private long frames;
  private long sinceNanos;

  private FrameRateLog() {}

  /** Begins when the window has just been shown, if somebody reads it. */
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
