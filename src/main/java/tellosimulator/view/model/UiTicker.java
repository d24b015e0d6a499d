package tellosimulator.view.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.time.Ticker;

/**
 * Updates the window: each tick mirrors the latest snapshot and then notifies the listeners. There
 * is one tick per frame while there is any motion or event, and two ticks a second otherwise. A
 * running {@link AnimationTimer} would make the toolkit process 60 pulses a second even if nothing
 * changes, so the timer is stopped while the window is idle. Confined to the JavaFX thread, except
 * {@link #wake}.
 */
public final class UiTicker {

  private static final Logger LOG = LoggerFactory.getLogger(UiTicker.class);

  /**
   * The time without motion or event after which the window is idle [ns]. Decided: by then
   * propellers have stopped, and the camera is at rest.
   */
  static final long CALM = 2_000_000_000;

  /**
   * Period of the ticks while idle [ns]. Decided: changes without a notification, such as an edited
   * file, become visible within this time. Measured: a tick takes a millisecond of processor time.
   */
  static final long IDLE_PERIOD = 500_000_000;

  private final Set<Object> failed = new HashSet<>();
  private final Runnable mirror;
  private final BooleanSupplier still;
  private final List<LongConsumer> listeners = new ArrayList<>();
  private final Ticker timing = new Ticker();
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final AnimationTimer timer =
      new AnimationTimer() {
        @Override
        public void handle(long nanos) {
          tick(nanos);
        }
      };

  private Optional<Worker> idleTicks = Optional.empty();
  private long eventfulNanos = Long.MIN_VALUE;
  private volatile boolean wanted = true;
  private volatile boolean idle;

  /**
   * Creates a stopped ticker.
   *
   * @param mirror updates the model from the latest snapshot
   * @param still returns whether nothing moves in the snapshot
   */
  public UiTicker(Runnable mirror, BooleanSupplier still) {
    this.mirror = mirror;
    this.still = still;
  }

  public void start() {
    idleTicks = Optional.of(Worker.start("window-idle", new IdleTicks()));
    timer.start();
  }

  public void stop() {
    timer.stop();
    idle = false;
    idleTicks.ifPresent(Worker::end);
    idleTicks = Optional.empty();
    timing.wake();
  }

  /** Returns whether there has been no motion or event for a while, so that ticks are rare. */
  public boolean idle() {
    return idle;
  }

  /**
   * Resumes ticking once per frame, from the next frame on. Thread-safe, and cheap even if called
   * often.
   */
  public void wake() {
    if (!wanted) {
      wanted = true;
    }
    if (!idle) {
      return;
    }
    if (Platform.isFxApplicationThread()) {
      resume();
    } else {
      runLater();
    }
  }

  /**
   * Runs one tick. Called by the toolkit or by a test.
   *
   * @param nanos the frame's time; only differences are meaningful [ns]
   */
  public void tick(long nanos) {
    guarded(mirror, mirror);
    for (LongConsumer listener : listeners) {
      guarded(listener, () -> listener.accept(nanos));
    }
    judge(nanos);
  }

  private void judge(long nanos) {
    if (wanted || !still.getAsBoolean()) {
      wanted = false;
      eventfulNanos = nanos;
      resume();
    } else if (!idle && nanos - eventfulNanos >= CALM) {
      sleep();
    }
  }

  private void sleep() {
    timer.stop();
    idle = true;
    timing.wake();
    if (wanted) { // set by a thread that had not seen the idle state
      resume();
    }
  }

  private void resume() {
    if (idle) {
      idle = false;
      idleTicks.ifPresent(running -> timer.start());
    }
  }

  /** Schedules a tick, unless one is already waiting for a busy JavaFX thread. */
  private void runLater() {
    if (scheduled.compareAndSet(false, true)) {
      try {
        Platform.runLater(this::tickOnce);
      } catch (IllegalStateException e) { // no toolkit: a test calls tick()
        scheduled.set(false);
      }
    }
  }

  private void tickOnce() {
    scheduled.set(false);
    if (idle) {
      tick(timing.nanos());
    }
  }

  /**
   * Schedules a tick every {@link #IDLE_PERIOD} while the window is idle, and rests while the
   * animation timer runs.
   */
  private final class IdleTicks implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("A tick of the idle window failed");

    @Override
    public Outcome doWork() {
      if (!idle) {
        return Outcome.IDLE;
      }
      if (timing.awaitTick(IDLE_PERIOD) && idle) {
        runLater();
      }
      return Outcome.WORKED;
    }

    @Override
    public void idle() {
      timing.rest();
      timing.restart();
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }
  }

  /**
   * Runs a part of the tick. A failure does not affect the other parts. It is logged once rather
   * than at each frame.
   */
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
   * Adds a listener that is notified after each new snapshot.
   *
   * @param listener receives the frame's time [ns]; must be quick
   */
  public void onTick(LongConsumer listener) {
    listeners.add(listener);
  }
}
