package tellosimulator.view.world;

import java.util.List;
import java.util.stream.Stream;
import javafx.geometry.Dimension2D;
import javafx.geometry.Rectangle2D;
import tellosimulator.math.Vec3;

/**
 * The picture of the room in the window, and what lies over it. Immutable; for any thread.
 *
 * @param size of the picture [px]
 * @param covered parts of it, from its top left corner [px]
 */
record PictureArea(Dimension2D size, List<Rectangle2D> covered) {

  /** What is left free at all edges [px]. Decided: half a number tag. */
  static final double MARGIN = 14;

  /** Shortest edge of a part in which one shows something [px]. Decided: a drone can be told. */
  static final double SMALLEST = 90;

  PictureArea {
    covered = List.copyOf(covered);
  }

  /** Whether there is none yet, or one in which nothing is shown. */
  boolean isEmpty() {
    return size.getWidth() < SMALLEST || size.getHeight() < SMALLEST;
  }

  /** Whether a place can be seen, unless something of the room hides it. */
  boolean shows(Vec3 place, Viewpoint viewpoint) {
    return viewpoint
        .project(place, size.getWidth(), size.getHeight())
        .filter(seen -> covered.stream().noneMatch(part -> part.contains(seen)))
        .isPresent();
  }

  /**
   * The free parts that cannot be larger at any side: those between edges and covers. They overlap.
   * All of the picture if none is large enough.
   */
  List<Rectangle2D> free() {
    Rectangle2D all = grown(new Rectangle2D(0, 0, size.getWidth(), size.getHeight()), -MARGIN);
    List<Rectangle2D> free = List.of(all);
    for (Rectangle2D cover : covered) {
      Rectangle2D blocked = grown(cover, MARGIN);
      free = free.stream().flatMap(part -> without(blocked, part)).distinct().toList();
    }
    return free.isEmpty() ? List.of(all) : free;
  }

  /**
   * A rectangle between a free part and all of the picture.
   *
   * @param share 0 is the part, 1 all of the picture
   */
  Rectangle2D between(Rectangle2D part, double share) {
    double left = part.getMinX() + (MARGIN - part.getMinX()) * share;
    double top = part.getMinY() + (MARGIN - part.getMinY()) * share;
    double right = part.getMaxX() + (size.getWidth() - MARGIN - part.getMaxX()) * share;
    double bottom = part.getMaxY() + (size.getHeight() - MARGIN - part.getMaxY()) * share;
    return new Rectangle2D(left, top, right - left, bottom - top);
  }

  /** What is left of a part at the four sides of something that may lie over it. */
  private static Stream<Rectangle2D> without(Rectangle2D blocked, Rectangle2D part) {
    if (!part.intersects(blocked)) {
      return Stream.of(part);
    }
    double width = part.getWidth();
    double height = part.getHeight();
    double left = Math.max(0, blocked.getMinX() - part.getMinX());
    double right = Math.max(0, part.getMaxX() - blocked.getMaxX());
    double above = Math.max(0, blocked.getMinY() - part.getMinY());
    double below = Math.max(0, part.getMaxY() - blocked.getMaxY());
    return Stream.of(
            new Rectangle2D(part.getMinX(), part.getMinY(), left, height),
            new Rectangle2D(part.getMaxX() - right, part.getMinY(), right, height),
            new Rectangle2D(part.getMinX(), part.getMinY(), width, above),
            new Rectangle2D(part.getMinX(), part.getMaxY() - below, width, below))
        .filter(rest -> rest.getWidth() >= SMALLEST && rest.getHeight() >= SMALLEST);
  }

  private static Rectangle2D grown(Rectangle2D part, double by) {
    return new Rectangle2D(
        part.getMinX() - by,
        part.getMinY() - by,
        Math.max(0, part.getWidth() + 2 * by),
        Math.max(0, part.getHeight() + 2 * by));
  }
}
