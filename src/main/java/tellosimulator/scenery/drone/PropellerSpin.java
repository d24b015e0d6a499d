package tellosimulator.scenery.drone;

import tellosimulator.model.FlightPhase;

/**
 * How the propellers of a drone turn in a frame: slower than real ones, of which one would see
 * nothing but flicker. It follows from the moment alone. Immutable; for any thread.
 *
 * @param blurred whether one sees discs instead of blades
 * @param angle how far the propellers have turned, within a turn [rad]
 */
public record PropellerSpin(boolean blurred, double angle) {

  /** Turning rate in a frame [rad/s]. Decided: by eye. */
  private static final double RATE = 26;

  /**
   * The spin at a moment.
   *
   * @param seconds on any clock
   */
  public static PropellerSpin of(FlightPhase phase, double seconds) {
    boolean turns = phase.motorsOn();
    return new PropellerSpin(turns && phase.flying(), turns ? RATE * seconds % (2 * Math.PI) : 0);
  }
}
