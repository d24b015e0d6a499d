package tellosimulator.scenery.furniture;

import tellosimulator.scenery.mesh.Texture;

/**
 * A texture, and the mapping from metres on a surface to texture coordinates. Immutable.
 *
 * @param texture texture of the surface
 * @param period length after which the texture's pattern repeats [m]
 * @param across mapping from metres to u
 * @param down mapping from metres upwards to 1 - v
 */
record TextureMapping(Texture texture, double period, Scale across, Scale down) {

  /**
   * The linear mapping from metres to a texture coordinate.
   *
   * @param start coordinate at 0 m
   * @param step increase of the coordinate per metre
   */
  record Scale(double start, double step) {

    /**
     * Maps a length to the range from the centre of the first texel to the centre of the last one,
     * so that the texture does not wrap around at the edges.
     */
    static Scale over(double length, int texels) {
      return new Scale(0.5 / texels, (1 - 1.0 / texels) / length);
    }

    double at(double meters) {
      return start + step * meters;
    }
  }

  /**
   * Returns the mapping of a texture whose pattern has the given period [m]. The texture covers
   * {@link PatternTexture#TILE}.
   */
  static TextureMapping repeating(Texture texture, double period) {
    Scale scale = new Scale(0, 1 / PatternTexture.TILE);
    return new TextureMapping(texture, period, scale, scale);
  }

  /**
   * Returns the mapping of an image that is shown once.
   *
   * @param width width of the covered area [m]
   * @param height height of the covered area [m]
   */
  static TextureMapping stretched(Texture image, double width, double height) {
    return new TextureMapping(
        image, width, Scale.over(width, image.width()), Scale.over(height, image.height()));
  }

  /**
   * Returns the length of texture that fits around a body without a seam: the nearest whole number
   * of periods [m]. Around a thin body, the length is not adjusted, because the texture would be
   * distorted too much.
   *
   * @param around circumference of the body [m]
   */
  double closed(double around) {
    return around < period / 2 ? around : Math.max(1, Math.rint(around / period)) * period;
  }

  /** Returns the texture coordinate at a distance to the right [m]. */
  double u(double right) {
    return across.at(right);
  }

  /** Returns the texture coordinate at a height [m]. */
  double v(double up) {
    return 1 - down.at(up);
  }
}
