package tellosimulator.scenery.furniture;

import tellosimulator.scenery.mesh.Texture;

/**
 * A texture, and how metres on a surface map to its coordinates. Immutable; for any thread.
 *
 * @param texture on the surface
 * @param period after how many metres it repeats [m]
 * @param across from metres to u
 * @param down from metres to v, upside down
 */
record TextureMapping(Texture texture, double period, Scale across, Scale down) {

  /**
   * Where a length is in a texture.
   *
   * @param start where 0 m is, in sizes of the texture
   * @param step how much of the texture a metre is
   */
  record Scale(double start, double step) {

    /** From the centre of the first texel to that of the last, or the edges would wrap around. */
    static Scale over(double length, int texels) {
      return new Scale(0.5 / texels, (1 - 1.0 / texels) / length);
    }

    double at(double meters) {
      return start + step * meters;
    }
  }

  /** A texture of {@link PatternTexture#TILE} whose pattern repeats after so many metres. */
  static TextureMapping repeating(Texture texture, double period) {
    Scale scale = new Scale(0, 1 / PatternTexture.TILE);
    return new TextureMapping(texture, period, scale, scale);
  }

  /**
   * An image, once.
   *
   * @param width of what it covers [m]
   * @param height of what it covers [m]
   */
  static TextureMapping stretched(Texture image, double width, double height) {
    return new TextureMapping(
        image, width, Scale.over(width, image.width()), Scale.over(height, image.height()));
  }

  /**
   * A length near to one around a thing, after which the pattern begins anew: no seam [m]. Around
   * thin things that would be too far from it, and a pattern stretched so much is not sharp.
   */
  double closed(double around) {
    return around < period / 2 ? around : Math.max(1, Math.rint(around / period)) * period;
  }

  /** The texture coordinate so many metres to the right. */
  double u(double right) {
    return across.at(right);
  }

  /** The texture coordinate so many metres up. */
  double v(double up) {
    return 1 - down.at(up);
  }
}
