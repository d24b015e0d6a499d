package tellosimulator.view.replay;

import java.util.List;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;

/**
 * The playback position of a recording, and its speed. Times are simulated seconds since the start
 * of the simulation. Confined to the JavaFX thread.
 */
final class Playback {

  /** The selectable speeds, as multiples of the recorded speed. */
  static final List<Double> SPEEDS = List.of(0.25, 0.5, 1.0, 2.0, 4.0, 8.0);

  /**
   * Maximum wall-clock time that counts between two frames [s]. Decided: after a window was hidden,
   * playback continues where it stopped.
   */
  private static final double LONGEST_FRAME = 0.25;

  /** Time before the end at which playback counts as finished [s]. */
  private static final double NEARLY = 0.01;

  private final double begin;
  private final double end;
  private final ReadOnlyDoubleWrapper time;
  private final BooleanProperty playing = new SimpleBooleanProperty(this, "playing");
  private final BooleanProperty held = new SimpleBooleanProperty(this, "held");
  private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(this, "speed", 1.0);
  private long lastNanos;

  /** Creates a paused playback at the first moment. */
  Playback(double begin, double end) {
    this.begin = begin;
    this.end = end;
    time = new ReadOnlyDoubleWrapper(this, "time", begin);
  }

  /** Returns the first moment [s]. */
  double begin() {
    return begin;
  }

  /** Returns the last moment [s]. */
  double end() {
    return end;
  }

  /** The displayed moment [s]. */
  ReadOnlyDoubleProperty timeProperty() {
    return time.getReadOnlyProperty();
  }

  /** Returns the displayed moment [s]. */
  double time() {
    return time.get();
  }

  /** Whether the playback is running. */
  BooleanProperty playingProperty() {
    return playing;
  }

  /** Whether the slider is being dragged, which suspends the playback. */
  BooleanProperty heldProperty() {
    return held;
  }

  /** The speed; one of {@link #SPEEDS}. */
  ObjectProperty<Double> speedProperty() {
    return speed;
  }

  /** Seeks to a moment [s], limited to the range of the recording. */
  void seek(double moment) {
    time.set(Math.max(begin, Math.min(end, moment)));
  }

  /** Moves forward by a number of seconds, or back if the number is negative. */
  void step(double seconds) {
    seek(time.get() + seconds);
  }

  /** Starts or pauses the playback. At the end of the recording, starts it from the beginning. */
  void toggle() {
    if (!playing.get() && time.get() >= end - NEARLY) {
      seek(begin);
    }
    playing.set(!playing.get());
  }

  /**
   * Changes the speed.
   *
   * @param steps the number of steps along {@link #SPEEDS}; negative to slow down
   */
  void faster(int steps) {
    int index = SPEEDS.indexOf(speed.get()) + steps;
    speed.set(SPEEDS.get(Math.max(0, Math.min(SPEEDS.size() - 1, index))));
  }

  /**
   * Advances with the wall clock while the playback is running.
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
