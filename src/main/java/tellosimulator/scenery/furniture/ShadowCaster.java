package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.world.Shape;

/**
 * An upright body with a rounded rectangle as its footprint, which shades the floor below and
 * around it. All in metres, in the frame of its obstacle.
 *
 * @param middle of the footprint
 * @param halfDepth half its edge along x, without the round corners
 * @param halfWidth half its edge along y, without the round corners
 * @param radius of the corners; without edges that is a disc
 * @param bottom height of its lower end above the floor
 * @param height from its lower to its upper end
 */
record ShadowCaster(
    Vec3 middle, double halfDepth, double halfWidth, double radius, double bottom, double height) {

  /** Opacity right beside what stands on the floor. Decided: by eye. */
  private static final double DARKEST = 0.55;

  /** What reaches no higher than this above the floor touches it [m]. Decided. */
  private static final double TOUCHING = 0.01;

  /** How far the shade of something that stands reaches at least, and at most [m]. Decided. */
  private static final double LEAST_SPREAD = 0.05;

  private static final double MOST_SPREAD = 0.5;

  /** How much farther it reaches for each metre of height, and of half the longer edge. */
  private static final double SPREAD_BY_HEIGHT = 0.5;

  private static final double SPREAD_BY_WIDTH = 1.4;

  /** How much farther it reaches for each metre that the body is above the floor. */
  private static final double SPREAD_BY_BOTTOM = 0.6;

  private static final double MOST_RAISED_SPREAD = 1;

  /** Those of a shape whose foot is so high above the floor. */
  static List<ShadowCaster> of(Shape shape, double base) {
    if (shape instanceof Shape.Box box) {
      return List.of(
          new ShadowCaster(Vec3.ZERO, box.depth() / 2, box.width() / 2, 0, base, box.height()));
    }
    if (shape instanceof Shape.Cylinder cylinder) {
      return List.of(disc(cylinder.radius(), base, cylinder.height()));
    }
    if (shape instanceof Shape.Ring ring) {
      double half = ring.tube() / 2;
      double reach = ring.radius() + ring.tube();
      double low = base + ring.middle() - ring.radius();
      List<ShadowCaster> casters = new ArrayList<>();
      casters.add(new ShadowCaster(Vec3.ZERO, half, reach, 0, low, 2 * ring.radius()));
      if (ring.post() > 0) {
        casters.add(disc(half, base, ring.post()));
      }
      return casters;
    }
    return ((Shape.Frame) shape).beams().stream().map(beam -> of(beam, base)).toList();
  }

  private static ShadowCaster of(Shape.Beam beam, double base) {
    Vec3 size = beam.size();
    return new ShadowCaster(
        beam.base().withZ(0), size.x() / 2, size.y() / 2, 0, base + beam.base().z(), size.z());
  }

  private static ShadowCaster disc(double radius, double base, double height) {
    return new ShadowCaster(Vec3.ZERO, 0, 0, radius, base, height);
  }

  /** Whether it stands on the floor, so that nobody sees what is right below it. */
  boolean stands() {
    return bottom < TOUCHING;
  }

  /** How far the shade fades out, from the edge of {@link #core} on. */
  double spread() {
    if (!stands()) {
      return Math.min(MOST_RAISED_SPREAD, LEAST_SPREAD + SPREAD_BY_BOTTOM * bottom);
    }
    double widest = Math.max(halfDepth, halfWidth) + radius;
    double most = Math.min(MOST_SPREAD, LEAST_SPREAD + SPREAD_BY_WIDTH * widest);
    return Math.min(most, LEAST_SPREAD + SPREAD_BY_HEIGHT * height);
  }

  /**
   * What is evenly dark: the footprint of what stands. Below what is raised light comes in from the
   * sides, so this is smaller by half of the spread.
   */
  ShadowCaster core() {
    if (stands()) {
      return this;
    }
    double smaller = spread() / 2;
    return new ShadowCaster(
        middle,
        Math.max(0, halfDepth - smaller),
        Math.max(0, halfWidth - smaller),
        Math.max(0, radius - smaller),
        bottom,
        height);
  }

  /** How dark it is at its darkest, 0 to 1; the narrower a raised body, the less. */
  double opacity() {
    return stands()
        ? DARKEST
        : DARKEST * covered(halfDepth + radius) * covered(halfWidth + radius) / (1 + bottom / 2);
  }

  private double covered(double half) {
    return half / (half + spread() / 2);
  }
}
