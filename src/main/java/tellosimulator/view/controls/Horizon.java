package tellosimulator.view.controls;

/**
 * The artificial horizon's geometry for a pitch, before the roll turns it. Lengths are in pixels
 * and measured down from the middle of a round dial.
 *
 * @param radius of the dial
 * @param offset of the horizon below the middle
 */
record Horizon(double radius, double offset) {

  /**
   * Pitch that puts the horizon at the dial's edge [deg]. Decided: twice the drone's largest tilt
   * of 25, so that a move tilts it by half the dial.
   */
  static final double PITCH_AT_EDGE = 50;

  /**
   * The horizon of a drone whose nose points up by {@code pitchDeg}: the more it points up, the
   * more sky there is.
   */
  static Horizon of(double pitchDeg, double radius) {
    double share = Math.max(-1, Math.min(1, pitchDeg / PITCH_AT_EDGE));
    return new Horizon(radius, share * radius);
  }

  /** Where the ground's circular segment begins, counter-clockwise from the right [deg]. */
  double groundStartDeg() {
    return 180 + Math.toDegrees(Math.asin(offset / radius));
  }

  /** How far the ground's circular segment reaches counter-clockwise [deg]. */
  double groundExtentDeg() {
    return 180 - 2 * Math.toDegrees(Math.asin(offset / radius));
  }

  /** Where the rung of the pitch ladder for an angle is. */
  double rung(double angleDeg) {
    return offset - angleDeg / PITCH_AT_EDGE * radius;
  }
}
