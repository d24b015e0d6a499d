package tellosimulator.view.world;

import java.util.List;
import java.util.stream.Stream;
import javafx.geometry.Dimension2D;
import javafx.geometry.Insets;
import javafx.geometry.Rectangle2D;
import tellosimulator.math.Vec3;

/**
 * The picture of the room in the window, and what lies over it. Immutable; for any thread.
 *
 * @param size of the picture [px]
 * @param aside what is covered along its edges [px]
 * @param covered other parts of it, from its top left corner [px]
 */
record PictureArea(Dimension2D size, Insets aside, List<Rectangle2D> covered) {

  /** What is left free at all edges [px]. Decided: half a drone tag. */
  static final double MARGIN = 14;

  /** Shortest edge of a part in which one shows something [px]. Decided: a drone can be told. */
  static final double SMALLEST = 90;

  PictureArea {
    covered = List.copyOf(covered);
  }

  /** Whether there is none yet, or one in which nothing is shown. */
  boolean isEmpty() {
    return size.getWidth() - aside.getLeft() - aside.getRight() < SMALLEST
        || size.getHeight() - aside.getTop() - aside.getBottom() < SMALLEST;
  }

  /** Whether a place can be seen, unless something of the room hides it. */
  boolean shows(Vec3 place, Viewpoint viewpoint) {
    return shows(place, viewpoint, 0);
  }

  /** Whether a place can be seen, and is not at the edge of what lies over the picture. */
  boolean showsClearly(Vec3 place, Viewpoint viewpoint) {
    return shows(place, viewpoint, MARGIN / 2);
  }

  private boolean shows(Vec3 place, Viewpoint viewpoint, double margin) {
    return viewpoint
        .project(place, size.getWidth(), size.getHeight())
        .filter(grown(open(), -margin)::contains)
        .filter(seen -> covered.stream().noneMatch(part -> grown(part, margin).contains(seen)))
        .isPresent();
  }

  /** All that nothing covers along an edge. */
  private Rectangle2D open() {
    return new Rectangle2D(
        aside.getLeft(),
        aside.getTop(),
        size.getWidth() - aside.getLeft() - aside.getRight(),
        size.getHeight() - aside.getTop() - aside.getBottom());
  }

  /**
   * The free parts that cannot be larger at any side: those between edges and covers. They overlap.
   * All between the edges if none is large enough.
   */
  List<Rectangle2D> free() {
    Rectangle2D all = grown(open(), -MARGIN);
    List<Rectangle2D> free = List.of(all);
    for (Rectangle2D cover : covered) {
      Rectangle2D blocked = grown(cover, MARGIN);
      free = free.stream().flatMap(part -> without(blocked, part)).distinct().toList();
    }
    return free.isEmpty() ? List.of(all) : free;
  }

  /**
   * A rectangle between a free part and all that nothing covers along an edge.
   *
   * @param share 0 is the part, 1 all of it
   */
  Rectangle2D between(Rectangle2D part, double share) {
    Rectangle2D all = grown(open(), -MARGIN);
    double left = part.getMinX() + (all.getMinX() - part.getMinX()) * share;
    double top = part.getMinY() + (all.getMinY() - part.getMinY()) * share;
    double right = part.getMaxX() + (all.getMaxX() - part.getMaxX()) * share;
    double bottom = part.getMaxY() + (all.getMaxY() - part.getMaxY()) * share;
    return new Rectangle2D(left, top, right - left, bottom - top);
  }

  /** A part, as far down as nothing covers along the lower edge. */
  Rectangle2D downwards(Rectangle2D part) {
    double bottom = Math.max(part.getMaxY(), grown(open(), -MARGIN).getMaxY());
    return new Rectangle2D(
        part.getMinX(), part.getMinY(), part.getWidth(), bottom - part.getMinY());
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
