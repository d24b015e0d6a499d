package tellosimulator.controller;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/**
 * A maneuver by a mission pad, which gives up when the pad is out of sight for too long, or when
 * its goal cannot be reached. For one drone and the simulation thread.
 */
final class PadWatch implements Maneuver {

  /** How long it flies without seeing the pad [s]. Measured: 15.2 (Tello-Python issue 88). */
  private static final double PATIENCE = 15.2;

  private final Maneuver maneuver;
  private final BooleanSupplier seen;
  private final boolean reachable;
  private final Phrase reason;
  private double unseen;

  private PadWatch(Maneuver maneuver, BooleanSupplier seen, boolean reachable, Phrase reason) {
    this.maneuver = maneuver;
    this.seen = seen;
    this.reachable = reachable;
    this.reason = reason;
  }

  /**
   * As long as a pad is in sight.
   *
   * @param pad its number
   * @param seen whether the drone sees it below now
   */
  static PadWatch over(Maneuver maneuver, int pad, BooleanSupplier seen) {
    Phrase reason = Phrase.of("it has not seen the pad m%d for %.1f s", pad, PATIENCE);
    return new PadWatch(maneuver, seen, true, reason);
  }

  /** To a place below the lowest hover: the drone flies as far as it can, and waits there. */
  static PadWatch inVain(Maneuver maneuver) {
    Phrase reason = Phrase.of("the place is too low, and not reached after %.1f s", PATIENCE);
    return new PadWatch(maneuver, () -> false, false, reason);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    unseen = seen.getAsBoolean() ? 0 : unseen + seconds;
    return maneuver.advance(sensed, seconds);
  }

  @Override
  public boolean planned() {
    return reachable && maneuver.planned();
  }

  @Override
  public Phrase progress() {
    return maneuver.progress();
  }

  @Override
  public Optional<Phrase> lost() {
    return unseen < PATIENCE || planned() ? Optional.empty() : Optional.of(reason);
  }
}
