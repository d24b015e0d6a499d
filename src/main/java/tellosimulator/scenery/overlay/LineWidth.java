package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;

/**
 * The thickness of a line in the air, as seen from one camera position. Near the camera, the
 * thickness is constant on the screen. Far away, it is constant in the room, so the line becomes
 * finer on the screen with distance. Immutable.
 *
 * @param camera position of the camera in the room frame [m]
 */
record LineWidth(Vec3 camera) {

  /**
   * Maximum of half the thickness [m]. Decided: seen from the other side of a room, a line is two
   * or three pixels wide.
   */
  static final double MOST = 0.007;

  /**
   * Half the thickness, as a fraction of the distance. Decided: seen from nearby, a line is two or
   * three pixels wide.
   */
  private static final double SHARE = 0.0014;

  /** Minimum of half the thickness [m]. Decided: finer than the eye resolves from a metre away. */
  private static final double LEAST = 0.0014;

  /**
   * Maximum ratio between the thickness of a line and the thickness that it should have. Decided:
   * the difference is less than a pixel.
   */
  private static final double WRONG = 1.25;

  /** Returns half the thickness at a place in the room [m]. */
  double half(Vec3 place) {
    return Math.max(LEAST, Math.min(MOST, SHARE * camera.distanceTo(place)));
  }

  /**
   * Returns whether a line with this thickness also looks right from another camera position, at a
   * given place.
   */
  boolean suits(LineWidth wanted, Vec3 place) {
    double ratio = half(place) / wanted.half(place);
    return ratio < WRONG && ratio * WRONG > 1;
  }
}
