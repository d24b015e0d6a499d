package tellosimulator.scenery.pad;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;

/**
 * The stars on a pad: simplified constellations of the real sky, each in a field that is 1 wide and
 * 0.6 high. The colours are based on the palette of Okabe and Ito (Color Universal Design, 2008),
 * and are distinguishable with any kind of colour vision.
 */
enum Constellation {
  CASSIOPEIA(0xd55e00, 0, 0.1, 0.24, 0.5, 0.47, 0.2, 0.72, 0.58, 1, 0.15),
  BIG_DIPPER(
      0x0072b2, 0, 0.1, 0.2, 0.05, 0.4, 0.15, 0.58, 0.25, 0.63, 0.55, 0.95, 0.58, 1, 0.22, 0.58,
      0.25),
  CYGNUS(
      0x009e73, 0, 0.3, 0.3, 0.32, 0.62, 0.34, 1, 0.36, 0.62, 0.34, 0.7, 0, 0.62, 0.34, 0.5, 0.6),
  LYRA(0xb0447f, 0.15, 0, 0.4, 0.14, 0.7, 0.06, 0.9, 0.46, 0.58, 0.56, 0.4, 0.14),
  LEO(
      0xc98a00, 0.1, 0.2, 0, 0.06, 0.16, 0, 0.3, 0.14, 0.3, 0.38, 0.75, 0.3, 1, 0.55, 0.68, 0.55,
      0.3, 0.38),
  SCORPIUS(
      0x2f8fd0, 0.95, 0, 1, 0.18, 0.8, 0.12, 0.62, 0.26, 0.5, 0.44, 0.32, 0.58, 0.12, 0.55, 0, 0.36,
      0.1, 0.24),
  CROSS(0x7a3fb0, 0.5, 0, 0.5, 0.6, 0.5, 0.28, 0.1, 0.24, 0.5, 0.28, 0.9, 0.34),
  ORION(
      0x8a5a2b, 0.1, 0, 0.42, 0.28, 0.5, 0.31, 0.58, 0.34, 0.9, 0.08, 0.58, 0.34, 0.85, 0.6, 0.15,
      0.56, 0.42, 0.28);

  private static final Point CORNER = new Point(56, 64);
  private static final double WIDTH = 228;
  private static final double STAR = 13;
  private static final double LINE = 4;

  private final Rgb color;
  private final List<Point> way = new ArrayList<>();

  Constellation(int rgb, double... places) {
    color = Rgb.of(rgb);
    for (int i = 0; i < places.length; i += 2) {
      way.add(new Point(places[i], places[i + 1]));
    }
  }

  /**
   * Returns the constellation of a pad.
   *
   * @param id number of the pad, from 1
   */
  static Constellation of(int id) {
    return values()[id - 1];
  }

  /** Returns the accent colour of the pad with this constellation. */
  Rgb color() {
    return color;
  }

  void draw(AlphaMask mask) {
    List<Point> stars =
        way.stream()
            .map(star -> new Point(CORNER.x() + WIDTH * star.x(), CORNER.y() + WIDTH * star.y()))
            .toList();
    mask.stroke(stars, LINE);
    stars.forEach(star -> mask.dot(star, STAR));
  }
}
