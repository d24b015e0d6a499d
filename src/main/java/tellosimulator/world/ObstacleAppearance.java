package tellosimulator.world;

import java.util.Map;

/**
 * What an obstacle looks like. Immutable.
 *
 * @param rgb its colour, as one writes #rrggbb
 * @param pictures image files that cover whole sides; around a cylinder goes that of the front
 */
public record ObstacleAppearance(int rgb, Pattern pattern, Map<Side, String> pictures) {

  /** Decided: an orange that neither walls nor floor have. */
  public static final ObstacleAppearance DEFAULT =
      new ObstacleAppearance(0xd9772b, Pattern.PLAIN, Map.of());

  public ObstacleAppearance {
    pictures = Map.copyOf(pictures);
  }

  /** What is painted on it in its colour. */
  public enum Pattern {
    /** Nothing. */
    PLAIN,
    /** Squares in two shades. */
    CHECKS,
    /** Stripes in two shades. */
    STRIPES,
    /** Bricks. */
    BRICKS
  }

  /** A side of a box, in the box's frame: x is ahead, y is left. */
  public enum Side {
    FRONT,
    BACK,
    LEFT,
    RIGHT,
    TOP,
    BOTTOM
  }
}
