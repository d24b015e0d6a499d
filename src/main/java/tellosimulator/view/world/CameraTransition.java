package tellosimulator.view.world;

import tellosimulator.scenery.orbit.Orbit;

/** Moves a camera smoothly from one orbit to another. Not thread-safe. */
final class CameraTransition {

  /** Duration of a transition [s]. Decided: long enough to see where the camera comes from. */
  static final double SECONDS = 0.3;

  private final Orbit from;
  private boolean begun;
  private double elapsed;

  CameraTransition(Orbit from) {
    this.from = from;
  }

  /**
   * Advances the time. The first call only starts the transition, because the window may have been
   * idle until then.
   *
   * @param seconds the time since the last call [s]
   */
  void advance(double seconds) {
    elapsed += begun ? seconds : 0;
    begun = true;
  }

  boolean over() {
    return elapsed >= SECONDS;
  }

  /**
   * Returns the current orbit on the way to another one. A smoothstep makes the motion start and
   * end at rest.
   */
  Orbit towards(Orbit to) {
    double part = Math.min(1, elapsed / SECONDS);
    return from.towards(to, part * part * (3 - 2 * part));
  }
}
