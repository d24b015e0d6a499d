package tellosimulator.scenery.pad;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/**
 * The texture of a mission pad: its number on a planet, a rocket that flies upwards, and stars in a
 * different constellation for each number. Decided: the whole design.
 */
final class PadTexture {

  /**
   * Side length of the texture [texels]. A texel is 0.4 mm wide, which is finer than a camera
   * resolves from 30 cm.
   */
  static final int SIZE = 512;

  private static final Rgb PAPER = Rgb.of(0xfbfaf6);
  private static final Rgb INK = Rgb.of(0x121418);

  private static final Point PLANET = new Point(164, 338);
  private static final double PLANET_RADIUS = 114;
  private static final double NUMBER_HEIGHT = 152;

  /** The tip of the rocket. */
  private static final Point TIP = new Point(380, 64);

  private PadTexture() {}

  /** Returns the texture of a pad. The texture is painted on first use. */
  static Texture of(int id) {
    return Texture.lazy(SIZE, SIZE, () -> painted(id).argb());
  }

  private static Canvas painted(int id) {
    Rgb color = Constellation.of(id).color();
    return new Canvas(SIZE, PAPER)
        .paint(INK, PadTexture::border)
        .paint(INK, mask -> Constellation.of(id).draw(mask))
        .paint(INK, mask -> mask.dot(PLANET, PLANET_RADIUS))
        .paint(PAPER, mask -> number(mask, id))
        .paint(color, PadTexture::flame)
        .paint(INK, PadTexture::hull)
        .paint(color, PadTexture::trim)
        .paint(PAPER, PadTexture::window);
  }

  private static void border(AlphaMask mask) {
    double near = 22;
    double far = SIZE - near;
    mask.stroke(Point.polyline(near, near, far, near, far, far, near, far, near, near), 20);
  }

  private static void number(AlphaMask mask, int id) {
    StrokeFont.draw(mask, Character.forDigit(id, 10), PLANET, NUMBER_HEIGHT);
    mask.stroke(
        new Arc(PLANET, new Point(PLANET_RADIUS - 16, PLANET_RADIUS - 16), 0, 2 * Math.PI).points(),
        4);
  }

  /** Draws the fins, and a hull that is pointed at the top and slender at the bottom. */
  private static void hull(AlphaMask mask) {
    List<Point> outline = new ArrayList<>();
    outline.addAll(side(1));
    List<Point> left = new ArrayList<>(side(-1));
    Collections.reverse(left);
    outline.addAll(left);
    mask.fill(outline);
    for (int side : new int[] {1, -1}) {
      mask.fill(
          List.of(at(side * 40, 190), at(side * 78, 288), at(side * 78, 330), at(side * 30, 284)));
    }
    mask.fill(List.of(at(-26, 280), at(26, 280), at(34, 304), at(-34, 304)));
  }

  /** Returns one side of the hull, from the tip down. */
  private static List<Point> side(int sign) {
    return List.of(
        at(0, 0),
        at(sign * 16, 24),
        at(sign * 30, 54),
        at(sign * 41, 90),
        at(sign * 48, 130),
        at(sign * 50, 170),
        at(sign * 46, 220),
        at(sign * 36, 262),
        at(sign * 28, 284));
  }

  private static void trim(AlphaMask mask) {
    mask.dot(at(0, 118), 27);
    mask.stroke(List.of(at(-30, 210), at(30, 210)), 9);
    mask.stroke(List.of(at(-26, 232), at(26, 232)), 9);
  }

  private static void window(AlphaMask mask) {
    mask.dot(at(0, 118), 17);
  }

  private static void flame(AlphaMask mask) {
    mask.fill(
        List.of(
            at(-30, 312),
            at(30, 312),
            at(34, 340),
            at(18, 364),
            at(0, 396),
            at(-18, 364),
            at(-34, 340)));
  }

  /** Converts a position relative to the tip of the rocket to a point in the texture. */
  private static Point at(double right, double down) {
    return new Point(TIP.x() + right, TIP.y() + down);
  }
}
