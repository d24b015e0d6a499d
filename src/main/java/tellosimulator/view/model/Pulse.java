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
 * The beat of the window: at each one the mirror takes over the newest snapshot, then those that
 * listen move on. It beats once a frame while something moves or happens, and twice a second while
 * nothing does: a running {@link AnimationTimer} alone keeps the toolkit busy 60 times a second.
 * For the JavaFX thread, but for {@link #wake}.
 */
public final class Pulse {

  private static final Logger LOG = LoggerFactory.getLogger(Pulse.class);

  /**
   * How long nothing has happened before the window is idle [ns]. Decided: propellers have run down
   * by then, and the camera has come to rest.
   */
  static final long CALM = 2_000_000_000;

  /**
   * From beat to beat while idle [ns]. Decided: what wakes nobody, such as a file that somebody
   * else changes, shows within this time. Measured: a beat takes a millisecond of a processor.
   */
  static final long IDLE_PERIOD = 500_000_000;

  private final Set<Object> failed = new HashSet<>();
  private final Runnable mirror;
  private final BooleanSupplier still;
  private final List<LongConsumer> listeners = new ArrayList<>();
  private final Ticker ticker = new Ticker();
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final AnimationTimer timer =
      new AnimationTimer() {
        @Override
        public void handle(long nanos) {
          beat(nanos);
        }
      };

  private Optional<Worker> idleBeats = Optional.empty();
  private long eventfulNanos = Long.MIN_VALUE;
  private volatile boolean wanted = true;
  private volatile boolean idle;

  /**
   * Does not beat yet.
   *
   * @param mirror takes over the newest snapshot
   * @param still whether nothing moves in it
   */
  public Pulse(Runnable mirror, BooleanSupplier still) {
    this.mirror = mirror;
    this.still = still;
  }

  public void start() {
    idleBeats = Optional.of(Worker.start("window-idle", new IdleBeats()));
    timer.start();
  }

  public void stop() {
    timer.stop();
    idle = false;
    idleBeats.ifPresent(Worker::end);
    idleBeats = Optional.empty();
    ticker.wake();
  }

  /** Whether nothing has moved or happened for a while, so that it beats seldom. */
  public boolean idle() {
    return idle;
  }

  /**
   * Something happens: from the next frame on it beats once a frame again. For any thread; cheap,
   * however often it is called.
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
   * One beat; called by the toolkit, or by a test.
   *
   * @param nanos the frame's time, of which only differences mean something [ns]
   */
  public void beat(long nanos) {
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
    ticker.wake();
    if (wanted) { // by a thread that did not see yet that it is idle
      resume();
    }
  }

  private void resume() {
    if (idle) {
      idle = false;
      idleBeats.ifPresent(running -> timer.start());
    }
  }

  /** One at a time waits for the JavaFX thread, however busy that is. */
  private void runLater() {
    if (scheduled.compareAndSet(false, true)) {
      try {
        Platform.runLater(this::beatOnce);
      } catch (IllegalStateException e) { // there is no toolkit: whoever beats in its place goes on
        scheduled.set(false);
      }
    }
  }

  private void beatOnce() {
    scheduled.set(false);
    if (idle) {
      beat(ticker.nanos());
    }
  }

  /** The slow beats; rests while the toolkit beats. */
  private final class IdleBeats implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("A beat of the idle window failed");

    @Override
    public Outcome doWork() {
      if (!idle) {
        return Outcome.IDLE;
      }
      if (ticker.awaitTick(IDLE_PERIOD) && idle) {
        runLater();
      }
      return Outcome.WORKED;
    }

    @Override
    public void idle() {
      ticker.rest();
      ticker.restart();
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
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
