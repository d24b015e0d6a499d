package tellosimulator.view.world;

/** A camera's smooth move from one orbit to another. For one thread. */
final class CameraTransition {

  /** How long it takes [s]. Decided: long enough to see from where one comes. */
  static final double SECONDS = 0.3;

  private final Orbit from;
  private boolean begun;
  private double elapsed;

  CameraTransition(Orbit from) {
    this.from = from;
  }

  /**
   * Lets time pass. The first time it only begins: an idle window may have slept until then.
   *
   * @param seconds since the last call
   */
  void advance(double seconds) {
    elapsed += begun ? seconds : 0;
    begun = true;
  }

  boolean over() {
    return elapsed >= SECONDS;
  }

  /** Where the camera is now on its way: a smooth step, which begins and ends at rest. */
  Orbit towards(Orbit to) {
    double part = Math.min(1, elapsed / SECONDS);
    return from.towards(to, part * part * (3 - 2 * part));
  }
}
