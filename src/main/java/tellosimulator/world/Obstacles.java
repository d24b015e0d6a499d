package tellosimulator.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import tellosimulator.math.Vec3;
import tellosimulator.world.Solid.Bounds;

/**
 * The obstacles of a room, indexed by a grid of cells on the floor, so that only nearby obstacles
 * are tested. Immutable.
 */
public final class Obstacles {

  /**
   * Minimum side length of a cell [m]. Decided: most obstacles then cover a few cells, and a drone
   * covers one or two.
   */
  private static final double SMALLEST_CELL = 1;

  /**
   * Maximum number of cells along an edge of the room. Decided: the grid then takes a few megabytes
   * at most.
   */
  private static final int MOST_CELLS = 64;

  /**
   * Maximum number of cells in which a part is listed. A part that covers more cells is not
   * indexed; instead, it is tested every time. Decided: even a long wall covers fewer cells.
   */
  private static final int MANY_CELLS = 100;

  private static final Part[] NOTHING = {};

  /** A solid, its bounding box, and the obstacle to which the solid belongs. */
  record Part(Solid solid, Bounds bounds, Obstacle obstacle) {}

  private final Room room;
  private final double cell;
  private final int columns;
  private final int rows;
  private final Part[][] cells;
  private final Part[] wide;
  private final boolean empty;

  private Obstacles(Room room, List<Part> parts) {
    this.room = room;
    this.cell = Math.max(SMALLEST_CELL, Math.max(room.depth(), room.width()) / MOST_CELLS);
    this.columns = (int) Math.ceil(room.depth() / cell);
    this.rows = (int) Math.ceil(room.width() / cell);
    this.empty = parts.isEmpty();
    this.cells = new Part[columns * rows][];
    Arrays.fill(cells, NOTHING);
    Map<Integer, List<Part>> lists = new HashMap<>();
    List<Part> everywhere = new ArrayList<>();
    for (Part part : parts) {
      if (cellCount(part.bounds) > MANY_CELLS) {
        everywhere.add(part);
      } else {
        addToCells(part, lists);
      }
    }
    this.wide = everywhere.toArray(NOTHING);
    for (Map.Entry<Integer, List<Part>> list : lists.entrySet()) {
      cells[list.getKey()] = list.getValue().toArray(NOTHING);
    }
  }

  /** Returns the obstacles of an arena. */
  public static Obstacles of(Arena arena) {
    List<Part> parts = new ArrayList<>();
    for (Obstacle obstacle : arena.obstacles()) {
      for (Solid solid : Solid.of(obstacle)) {
        parts.add(new Part(solid, solid.bounds(), obstacle));
      }
    }
    return new Obstacles(arena.room(), parts);
  }

  /**
   * Returns the collision that stops a body during a step, if any. The body slides along the object
   * that it touches.
   *
   * @param before the previous position [m]
   * @param position the position that the body would reach without a collision [m]
   * @param velocity the velocity [m/s]
   */
  public Optional<Collision> collide(Vec3 before, Vec3 position, Vec3 velocity, Collider collider) {
    if (empty) {
      return Optional.empty();
    }
    Vec3 grown = new Vec3(collider.radius(), collider.radius(), collider.height());
    Bounds swept = Bounds.around(before, grown).with(Bounds.around(position, grown));
    List<Part> near = near(swept);
    return near.isEmpty()
        ? Optional.empty()
        : new Sweep(near, collider).along(before, position, velocity);
  }

  /** Returns an obstacle that a collider overlaps, if any. */
  public Optional<Obstacle> around(Vec3 position, Collider collider) {
    Vec3 grown = new Vec3(collider.radius(), collider.radius(), collider.height());
    for (Part part : near(Bounds.around(position, grown))) {
      if (part.solid.penetration(position, position, collider).isPresent()) {
        return Optional.of(part.obstacle);
      }
    }
    return Optional.empty();
  }

  /**
   * Returns an obstacle that another one overlaps, if any.
   *
   * @param obstacle one of these obstacles
   * @param counts whether an overlap with the given obstacle counts
   */
  public Optional<Obstacle> overlapping(Obstacle obstacle, Predicate<Obstacle> counts) {
    for (Solid solid : Solid.of(obstacle)) {
      for (Part part : near(solid.bounds())) {
        if (!part.obstacle.equals(obstacle)
            && counts.test(part.obstacle)
            && solid.overlaps(part.solid)) {
          return Optional.of(part.obstacle);
        }
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the free distance along a ray [m].
   *
   * @param direction a unit vector
   * @param limit the maximum distance [m]
   * @return the distance to the nearest obstacle, or {@code limit}
   */
  public double distance(Vec3 origin, Vec3 direction, double limit) {
    if (empty) {
      return limit;
    }
    Vec3 end = origin.plusScaled(direction, limit);
    Bounds along = Bounds.around(origin, Vec3.ZERO).with(Bounds.around(end, Vec3.ZERO));
    double nearest = limit;
    for (Part part : near(along)) {
      nearest = Math.min(nearest, part.solid.distance(origin, direction));
    }
    return nearest;
  }

  /**
   * Returns the parts whose bounds intersect the given bounds. The result may contain a part more
   * than once.
   */
  private List<Part> near(Bounds bounds) {
    int firstColumn = column(bounds.least().x());
    int lastColumn = column(bounds.most().x());
    int firstRow = row(bounds.least().y());
    int lastRow = row(bounds.most().y());
    List<Part> near = List.of();
    for (Part part : wide) {
      if (part.bounds.meets(bounds)) {
        near = near.isEmpty() ? new ArrayList<>(4) : near;
        near.add(part);
      }
    }
    for (int column = firstColumn; column <= lastColumn; column++) {
      for (int row = firstRow; row <= lastRow; row++) {
        for (Part part : cells[column * rows + row]) {
          if (part.bounds.meets(bounds)) {
            near = near.isEmpty() ? new ArrayList<>(4) : near;
            near.add(part);
          }
        }
      }
    }
    return near;
  }

  private int cellCount(Bounds bounds) {
    return (column(bounds.most().x()) - column(bounds.least().x()) + 1)
        * (row(bounds.most().y()) - row(bounds.least().y()) + 1);
  }

  private void addToCells(Part part, Map<Integer, List<Part>> lists) {
    Bounds bounds = part.bounds;
    int lastColumn = column(bounds.most().x());
    int firstRow = row(bounds.least().y());
    int lastRow = row(bounds.most().y());
    for (int column = column(bounds.least().x()); column <= lastColumn; column++) {
      for (int row = firstRow; row <= lastRow; row++) {
        lists.computeIfAbsent(column * rows + row, index -> new ArrayList<>()).add(part);
      }
    }
  }

  private int column(double x) {
    return clamped((int) Math.floor((x + room.depth() / 2) / cell), columns);
  }

  private int row(double y) {
    return clamped((int) Math.floor((y + room.width() / 2) / cell), rows);
  }

  private static int clamped(int index, int count) {
    return Math.max(0, Math.min(count - 1, index));
  }
}
