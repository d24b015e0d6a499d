package tellosimulator.view;

import java.lang.management.ManagementFactory;
import javafx.animation.AnimationTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Notes in the log (level debug) when the window can be used, which benchmarks read. For the JavaFX
 * thread.
 */
final class FirstFrame extends AnimationTimer {

  private static final Logger LOG = LoggerFactory.getLogger(FirstFrame.class);

  /** The first pulse lays out and hands over a frame, the second one begins when it was taken. */
  private static final int PULSES = 2;

  private int pulses;

  private FirstFrame() {}

  /** Reports when what has just been shown is on the screen. */
  static void report() {
    new FirstFrame().start();
  }

  @Override
  public void handle(long nanos) {
    pulses++;
    if (pulses == PULSES) {
      stop();
      if (LOG.isDebugEnabled()) {
        long start = ManagementFactory.getRuntimeMXBean().getStartTime();
        LOG.debug(
            "The window can be used, {} ms after the start", System.currentTimeMillis() - start);
      }
    }
  }
}
