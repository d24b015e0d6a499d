package tellosimulator.video.camera;

/**
 * A version of a texture in some size and colour space. Where the space is coarse ({@link
 * ColorSpace#coarse()}), second and third channel, and their opacity, are half as wide and high, as
 * about one of their pixels falls on one of the picture's colours. Immutable; for any thread.
 */
record Level(Quads first, Quads second, Quads third, Quads opacity, Quads colorOpacity) {

  /** A version of a texture of which nothing is translucent. */
  static Level opaque(Texels fine, Texels coarse) {
    return new Level(
        fine.channel(Lanes.FIRST),
        coarse.channel(Lanes.SECOND),
        coarse.channel(Lanes.THIRD),
        Quads.OPAQUE,
        Quads.OPAQUE);
  }

  /** A version of a texture that may be translucent. */
  static Level masked(Texels fine, Texels coarse) {
    return new Level(
        fine.channel(Lanes.FIRST),
        coarse.channel(Lanes.SECOND),
        coarse.channel(Lanes.THIRD),
        fine.channel(Lanes.OPACITY),
        coarse.channel(Lanes.OPACITY));
  }

  int width() {
    return first.width();
  }

  int height() {
    return first.height();
  }
}
