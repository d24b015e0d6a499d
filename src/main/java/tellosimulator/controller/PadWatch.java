package tellosimulator.controller;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** A maneuver by a mission pad, which gives up when the pad is out of sight for too long. */
final class PadWatch implements Maneuver {

  /** How long it flies without seeing the pad [s]. Measured: 15.2 (Tello-Python issue 88). */
  private static final double PATIENCE = 15.2;

  private final Maneuver maneuver;
  private final int pad;
  private final BooleanSupplier seen;
  private double unseen;

  /**
   * @param pad its number
   * @param seen whether the drone sees it now
   */
  PadWatch(Maneuver maneuver, int pad, BooleanSupplier seen) {
    this.maneuver = maneuver;
    this.pad = pad;
    this.seen = seen;
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    unseen = seen.getAsBoolean() ? 0 : unseen + seconds;
    return maneuver.advance(sensed, seconds);
  }

  @Override
  public boolean planned() {
    return maneuver.planned();
  }

  @Override
  public Phrase progress() {
    return maneuver.progress();
  }

  @Override
  public Optional<Phrase> lost() {
    return unseen < PATIENCE || planned()
        ? Optional.empty()
        : Optional.of(Phrase.of("it has not seen the pad m%d for %.1f s", pad, PATIENCE));
  }
}
