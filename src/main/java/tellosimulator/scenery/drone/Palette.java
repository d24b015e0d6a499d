package tellosimulator.scenery.drone;

import java.util.Arrays;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;

/**
 * The colours of a drone's parts. All of them are in one small picture, so that a whole body is one
 * mesh with one material. Assumed: by eye, from pictures of a Tello.
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
  PROPELLER(Rgb.of(0x4b4f57)),
  FOOT(Rgb.of(0x6a6e75));

  /** Pixels from one colour to the next; what lies between hides the neighbours from filters. */
  private static final int CELL = 8;

  private final Rgb color;

  Palette(Rgb color) {
    this.color = color;
  }

  /** Its place in the order of all. */
  int index() {
    return Arrays.asList(values()).indexOf(this);
  }

  /** Where each colour lies in the picture: u and v of the first one, then of the next. */
  static float[] places() {
    float[] places = new float[2 * values().length];
    for (Palette part : values()) {
      places[2 * part.index()] = (part.index() + 0.5f) / values().length;
      places[2 * part.index() + 1] = 0.5f;
    }
    return places;
  }

  /** The picture for a drone with a cover of some colour. */
  static Texture picture(Rgb cover) {
    int width = CELL * values().length;
    int[] pixels = new int[width * CELL];
    for (int i = 0; i < pixels.length; i++) {
      Palette part = values()[i % width / CELL];
      pixels[i] = (part == COVER ? cover : part.color).argb();
    }
    return new Texture(width, CELL, pixels);
  }
}
