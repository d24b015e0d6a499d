package tellosimulator.scenery.room;

/**
 * The shadow that a drone casts straight down: it shrinks and fades as the drone rises, but never
 * vanishes.
 *
 * @param radius metres
 * @param opacity 0 to 1
 */
record Shadow(double radius, double opacity) {

  /** On the floor [m]: a little more than the drone. Decided: by eye. */
  private static final double LARGEST = 0.15;

  private static final double SMALLEST = 0.08;

  private static final double DARKEST = 0.6;

  private static final double LIGHTEST = 0.22;

  /** Height at which half of the change has happened [m]. Decided: by eye. */
  private static final double HALF_HEIGHT = 1.2;

  /** The shadow of a drone at a height above the floor [m]. */
  static Shadow at(double height) {
    double near = HALF_HEIGHT / (HALF_HEIGHT + Math.max(0, height));
    return new Shadow(
        SMALLEST + (LARGEST - SMALLEST) * near, LIGHTEST + (DARKEST - LIGHTEST) * near);
  }
}
