package tellosimulator.world;

import java.util.Map;

/**
 * The appearance of an obstacle. Immutable.
 *
 * @param rgb the colour, as {@code 0xrrggbb}
 * @param pictures the image files by side; each image covers a whole side, and the front image of a
 *     cylinder wraps around the cylinder
 */
public record ObstacleAppearance(int rgb, Pattern pattern, Map<Side, String> pictures) {

  /** The default appearance. Decided: an orange that does not occur on the walls or the floor. */
  public static final ObstacleAppearance DEFAULT =
      new ObstacleAppearance(0xd9772b, Pattern.PLAIN, Map.of());

  public ObstacleAppearance {
    pictures = Map.copyOf(pictures);
  }

  /** The pattern of the paint. */
  public enum Pattern {
    /** No pattern. */
    PLAIN,
    /** Squares in the obstacle's colour and in a contrasting colour. */
    CHECKS,
    /** Diagonal stripes in the obstacle's colour and in a contrasting colour. */
    STRIPES,
    /** Bricks in the obstacle's colour, with light mortar. */
    BRICKS
  }

  /** A side of a box, in the box's frame: the front is at positive x, the left at positive y. */
  public enum Side {
    FRONT,
    BACK,
    LEFT,
    RIGHT,
    TOP,
    BOTTOM
  }
}
