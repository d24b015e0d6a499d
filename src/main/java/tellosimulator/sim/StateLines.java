package tellosimulator.sim;

import java.util.Optional;
import tellosimulator.profile.Behavior;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sensor.SeededNoise.Channel;
import tellosimulator.time.Periodic;
import tellosimulator.time.SimTime;

/** When a drone's state lines are due, and whether its operator waits for one. For one thread. */
final class StateLines {

  /** Mean period of state lines with a real drone, its deviation and limits [s]. Measured. */
  private static final double MEASURED_PERIOD = 0.1006;

  private static final double PERIOD_DEVIATION = 0.011;
  private static final double SHORTEST_PERIOD = 0.045;
  private static final double LONGEST_PERIOD = 0.153;

  /** Period of state lines [s]. Report. */
  private static final double PERIOD = 0.1;

  private final Behavior behavior;
  private final SeededNoise noise;
  private Optional<Periodic> lines = Optional.empty();
  private boolean owed;
  private long count;

  StateLines(Behavior behavior, SeededNoise noise) {
    this.behavior = behavior;
    this.noise = noise;
  }

  /** Lets the first one be due now, unless they have begun before. */
  void begin(SimTime now) {
    if (lines.isEmpty()) {
      lines = Optional.of(new Periodic(now, this::period));
    }
  }

  /** None is due any more. */
  void end() {
    lines = Optional.empty();
    owed = false;
  }

  /** A command came, so its operator waits for the next one. */
  void owe() {
    owed = lines.isPresent();
  }

  /** Whether a command came since the last one. */
  boolean owed() {
    return owed;
  }

  /** Whether one is due at the end of this step; if so, it is counted as sent. */
  boolean due(SimTime now) {
    boolean due = lines.isPresent() && lines.get().due(now);
    owed &= !due;
    return due;
  }

  private double period() {
    if (!behavior.noisySensors()) {
      return PERIOD;
    }
    double period =
        MEASURED_PERIOD + PERIOD_DEVIATION * noise.gaussian(Channel.STATE_PERIOD, count++);
    return Math.max(SHORTEST_PERIOD, Math.min(LONGEST_PERIOD, period));
  }
}
