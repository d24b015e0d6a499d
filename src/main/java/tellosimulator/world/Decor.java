package tellosimulator.world;

import java.util.List;
import java.util.OptionalInt;

/**
 * What can be chosen about the looks of a room; nothing of it stops a drone. Immutable.
 *
 * @param grid distance between the lines on the floor [m]
 * @param accent colour of the front wall where the room is calm, and hue of its bricks where it is
 *     textured, {@code 0xrrggbb}; the usual one if empty
 * @param posters the later ones in front of the earlier ones
 */
public record Decor(double grid, Walls walls, OptionalInt accent, List<Poster> posters) {

  /** Limits of the grid [m]. Decided: a drone's size, and a line each two metres. */
  public static final double SMALLEST_GRID = 0.1;

  public static final double LARGEST_GRID = 2;

  /** Decided: the grid of the predecessor, and walls that suit cameras and people. */
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
