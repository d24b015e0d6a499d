package tellosimulator.view;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongConsumer;
import javafx.animation.AnimationTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The beat of the window: once a frame the mirror takes over the newest snapshot, then those that
 * listen move on. For the JavaFX thread.
 */
public final class Pulse {

  private static final Logger LOG = LoggerFactory.getLogger(Pulse.class);

  private final Set<Object> failed = new HashSet<>();
  private final Runnable mirror;
  private final List<LongConsumer> listeners = new ArrayList<>();
  private final AnimationTimer timer =
      new AnimationTimer() {
        @Override
        public void handle(long nanos) {
          beat(nanos);
        }
      };

  /**
   * Does not beat yet.
   *
   * @param mirror takes over the newest snapshot
   */
  public Pulse(Runnable mirror) {
    this.mirror = mirror;
  }

  public void start() {
    timer.start();
  }

  public void stop() {
    timer.stop();
  }

  /**
   * One beat; called by the toolkit, or by a test.
   *
   * @param nanos the frame's time, of which only differences mean something [ns]
   */
  public void beat(long nanos) {
    guarded(mirror, mirror);
    for (LongConsumer listener : listeners) {
      guarded(listener, () -> listener.accept(nanos));
    }
  }

  /** One that fails does not hold up the others, and complains once rather than at each frame. */
  private void guarded(Object who, Runnable work) {
    try {
      work.run();
    } catch (RuntimeException e) {
      if (failed.add(who)) {
        LOG.error("A part of the window failed; please report this: {}", e.toString(), e);
      }
    }
  }

  /**
   * Lets something move on after each new snapshot.
   *
   * @param listener takes the frame's time [ns]; must be quick
   */
  public void onBeat(LongConsumer listener) {
    listeners.add(listener);
  }
}
