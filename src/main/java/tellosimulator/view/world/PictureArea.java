package tellosimulator.view.world;

import java.util.List;
import java.util.stream.Stream;
import javafx.geometry.Dimension2D;
import javafx.geometry.Insets;
import javafx.geometry.Rectangle2D;
import tellosimulator.math.Vec3;

/**
 * The size of the 3D view in the window, and the areas that are covered by controls. Immutable.
 *
 * @param size the size of the view [px]
 * @param aside the widths that are covered along the edges of the view [px]
 * @param covered other covered areas, from the top left corner of the view [px]
 */
record PictureArea(Dimension2D size, Insets aside, List<Rectangle2D> covered) {

  /** Margin that is kept free at all edges [px]. Decided: half the size of a drone tag. */
  static final double MARGIN = 14;

  /** Shortest edge of a usable area [px]. Decided: large enough to recognize a drone. */
  static final double SMALLEST = 90;

  PictureArea {
    covered = List.copyOf(covered);
  }

  /** Returns whether the view has no size yet, or too little uncovered space. */
  boolean isEmpty() {
    return size.getWidth() - aside.getLeft() - aside.getRight() < SMALLEST
        || size.getHeight() - aside.getTop() - aside.getBottom() < SMALLEST;
  }

  /**
   * Returns whether a place is in the uncovered part of the view. Whether an object in the room
   * hides the place is not considered.
   */
  boolean shows(Vec3 place, Viewpoint viewpoint) {
    return shows(place, viewpoint, 0);
  }

  /**
   * Returns whether a place is in the uncovered part of the view, with a margin to the controls.
   */
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

  /** Returns the area between the covered edges. */
  private Rectangle2D open() {
    return new Rectangle2D(
        aside.getLeft(),
        aside.getTop(),
        size.getWidth() - aside.getLeft() - aside.getRight(),
        size.getHeight() - aside.getTop() - aside.getBottom());
  }

  /**
   * Returns the maximal uncovered rectangles, which may overlap. If none is large enough, returns
   * the whole area between the covered edges.
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
   * Interpolates between a free part and the whole area between the covered edges.
   *
   * @param share 0 for the part, 1 for the whole area
   */
  Rectangle2D between(Rectangle2D part, double share) {
    Rectangle2D all = grown(open(), -MARGIN);
    double left = part.getMinX() + (all.getMinX() - part.getMinX()) * share;
    double top = part.getMinY() + (all.getMinY() - part.getMinY()) * share;
    double right = part.getMaxX() + (all.getMaxX() - part.getMaxX()) * share;
    double bottom = part.getMaxY() + (all.getMaxY() - part.getMaxY()) * share;
    return new Rectangle2D(left, top, right - left, bottom - top);
  }

  /** Extends a part downwards to the covered lower edge. */
  Rectangle2D downwards(Rectangle2D part) {
    double bottom = Math.max(part.getMaxY(), grown(open(), -MARGIN).getMaxY());
    return new Rectangle2D(
        part.getMinX(), part.getMinY(), part.getWidth(), bottom - part.getMinY());
  }

  /**
   * Returns the rectangles that remain of a part on the four sides of a blocked area. Rectangles
   * that are too small are omitted.
   */
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
