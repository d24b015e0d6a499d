package tellosimulator.scenery.drone;

import java.util.Arrays;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The colours of a drone, in one small texture atlas, so that a whole body is one mesh with one
 * material. Assumed: by eye, from pictures of a Tello.
 */
enum Palette {
  COVER(Rgb.of(0xeceded)),
  SEAM(Rgb.of(0xa9adb2)),
  UNDERSIDE(Rgb.of(0x33363b)),
  NOSE(Rgb.of(0x17181b)),
  LENS_RING(Rgb.of(0x4a4e55)),
  LENS(Rgb.of(0x1d2c4d)),
  GLINT(Rgb.of(0x9cc3f5)),
  ARM(Rgb.of(0x2b2d31)),
  MOTOR(Rgb.of(0x3d4147)),
  CAP(Rgb.of(0x8d9198)),
  GUARD(Rgb.of(0x222428)),
  /** A light colour, so that a drone also stands out against dark floors. */
  RIM(Rgb.of(0xd3d8de)),
  PROPELLER(Rgb.of(0x4b4f57)),
  FOOT(Rgb.of(0x6a6e75));

  /**
   * Side length of the square of one colour [texels]. It is large enough that filters do not blend
   * neighbouring colours.
   */
  private static final int CELL = 8;

  private final Rgb color;

  Palette(Rgb color) {
    this.color = color;
  }

  /** Returns the position of this colour in the atlas, from 0. */
  int index() {
    return Arrays.asList(values()).indexOf(this);
  }

  /** Returns the texture coordinates of all colours in order, u and v for each. */
  static float[] texCoords() {
    float[] texCoords = new float[2 * values().length];
    for (Palette part : values()) {
      texCoords[2 * part.index()] = (part.index() + 0.5f) / values().length;
      texCoords[2 * part.index() + 1] = 0.5f;
    }
    return texCoords;
  }

  /** Creates the texture of a drone whose cover has the given colour. */
  static Texture texture(Rgb cover) {
    int width = CELL * values().length;
    int[] pixels = new int[width * CELL];
    for (int i = 0; i < pixels.length; i++) {
      Palette part = values()[i % width / CELL];
      pixels[i] = (part == COVER ? cover : part.color).argb();
    }
    return new Texture(width, CELL, pixels);
  }
}
