package tellosimulator.world;

import java.util.List;
import java.util.OptionalInt;

/**
 * The configurable appearance of a room. It has no effect on flights, but goals may refer to
 * posters. Immutable.
 *
 * @param grid the distance between the lines on the floor [m]
 * @param accent the colour of the front wall ({@link Walls#AUTO}) or the hue of its bricks ({@link
 *     Walls#TEXTURED}), as {@code 0xrrggbb}; empty for the default; unused for {@link Walls#PLAIN}
 * @param posters the posters; later ones hang in front of earlier ones
 */
public record Decor(double grid, Walls walls, OptionalInt accent, List<Poster> posters) {

  /** Minimum grid spacing [m]. Decided: the size of a drone. */
  public static final double SMALLEST_GRID = 0.1;

  /** Maximum grid spacing [m]. Decided. */
  public static final double LARGEST_GRID = 2;

  /**
   * The default appearance. Decided: the grid of this simulator's predecessor of 2020, and {@link
   * Walls#AUTO}, because it looks the same in the window and in the drones' video.
   */
  public static final Decor DEFAULT = new Decor(0.4, Walls.AUTO, OptionalInt.empty(), List.of());

  public Decor {
    if (!(grid >= SMALLEST_GRID && grid <= LARGEST_GRID)) {
      throw new IllegalArgumentException(
          "grid is " + grid + " m, but must be from " + SMALLEST_GRID + " to " + LARGEST_GRID);
    }
    posters = List.copyOf(posters);
  }

  public Decor withGrid(double newGrid) {
    return new Decor(newGrid, walls, accent, posters);
  }

  public Decor withWalls(Walls newWalls) {
    return new Decor(grid, newWalls, accent, posters);
  }

  public Decor withPosters(List<Poster> newPosters) {
    return new Decor(grid, walls, accent, newPosters);
  }
}
