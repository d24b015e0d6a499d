package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;

/**
 * How thick a line in the air is drawn for a camera: equally thick in the picture from near, and
 * equally thick in the room from afar, where it gets finer with distance. Immutable.
 *
 * @param camera its position, room frame [m]
 */
record LineWidth(Vec3 camera) {

  /** The most half a thickness can be [m]. Decided: two or three pixels across a room. */
  static final double MOST = 0.007;

  /** Half the thickness, as a share of the distance. Decided: two or three pixels from near. */
  private static final double SHARE = 0.0014;

  /** The least half a thickness can be [m]. Decided: finer than one sees from a metre away. */
  private static final double LEAST = 0.0014;

  /** By which factor a thickness may be wrong. Decided: less than a pixel. */
  private static final double WRONG = 1.25;

  /** Half the thickness at a place of the room [m]. */
  double half(Vec3 place) {
    return Math.max(LEAST, Math.min(MOST, SHARE * camera.distanceTo(place)));
  }

  /** Whether what was made for this camera is good enough for another one, at a place. */
  boolean suits(LineWidth wanted, Vec3 place) {
    double ratio = half(place) / wanted.half(place);
    return ratio < WRONG && ratio * WRONG > 1;
  }
}
