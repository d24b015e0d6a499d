package tellosimulator.scenery.drone;

import tellosimulator.model.FlightPhase;

/**
 * The displayed rotation of a drone's propellers at one moment. It is slower than the real
 * rotation, because the real rotation would only flicker. The displayed rotation depends only on
 * the flight phase and the time. Immutable.
 *
 * @param blurred whether discs are drawn instead of blades
 * @param angle angle of the propellers, within one turn [rad]
 */
public record PropellerSpin(boolean blurred, double angle) {

  /** Displayed rotation rate [rad/s]. Decided: by eye. */
  private static final double RATE = 26;

  /**
   * Returns the spin at a given time.
   *
   * @param seconds time on any clock
   */
  public static PropellerSpin of(FlightPhase phase, double seconds) {
    boolean turns = phase.motorsOn();
    return new PropellerSpin(turns && phase.flying(), turns ? RATE * seconds % (2 * Math.PI) : 0);
  }
}
