package tellosimulator.view.replay;

import java.util.List;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;

/**
 * Which moment of a recording is shown, and how it goes on. Times are simulated seconds since the
 * simulation began. For the JavaFX thread.
 */
final class Playback {

  /** How many times as fast as it was flown. */
  static final List<Double> SPEEDS = List.of(0.25, 0.5, 1.0, 2.0, 4.0, 8.0);

  /** A window that was covered goes on where it was: longer frames count as this [s]. Decided. */
  private static final double LONGEST_FRAME = 0.25;

  /** So near to the end it is over [s]. */
  private static final double NEARLY = 0.01;

  private final double begin;
  private final double end;
  private final ReadOnlyDoubleWrapper time;
  private final BooleanProperty playing = new SimpleBooleanProperty(this, "playing");
  private final BooleanProperty held = new SimpleBooleanProperty(this, "held");
  private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(this, "speed", 1.0);
  private long lastNanos;

  /** Stands at the first moment. */
  Playback(double begin, double end) {
    this.begin = begin;
    this.end = end;
    time = new ReadOnlyDoubleWrapper(this, "time", begin);
  }

  /** The first moment [s]. */
  double begin() {
    return begin;
  }

  /** The last moment [s]. */
  double end() {
    return end;
  }

  /** The moment that is shown [s]. */
  ReadOnlyDoubleProperty timeProperty() {
    return time.getReadOnlyProperty();
  }

  /** The moment that is shown [s]. */
  double time() {
    return time.get();
  }

  /** Whether it goes on by itself. */
  BooleanProperty playingProperty() {
    return playing;
  }

  /** Whether somebody holds the slider, so that it waits. */
  BooleanProperty heldProperty() {
    return held;
  }

  /** One of {@link #SPEEDS}. */
  ObjectProperty<Double> speedProperty() {
    return speed;
  }

  /** Goes to a moment, or as near to it as there are any [s]. */
  void seek(double moment) {
    time.set(Math.max(begin, Math.min(end, moment)));
  }

  /** Goes some seconds on; back if they are negative. */
  void step(double seconds) {
    seek(time.get() + seconds);
  }

  /** Plays or pauses; what is over begins anew. */
  void toggle() {
    if (!playing.get() && time.get() >= end - NEARLY) {
      seek(begin);
    }
    playing.set(!playing.get());
  }

  /**
   * Plays faster or slower.
   *
   * @param steps along {@link #SPEEDS}
   */
  void faster(int steps) {
    int index = SPEEDS.indexOf(speed.get()) + steps;
    speed.set(SPEEDS.get(Math.max(0, Math.min(SPEEDS.size() - 1, index))));
  }

  /**
   * Moves on with the wall clock, if it plays.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    double seconds = lastNanos == 0 ? 0 : Math.min(LONGEST_FRAME, (nanos - lastNanos) / 1e9);
    lastNanos = nanos;
    if (playing.get() && !held.get()) {
      step(seconds * speed.get());
      playing.set(time.get() < end);
    }
  }
}
