package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;

/**
 * Tracks the areas of the plan that symbols and labels occupy, so that labels cover neither symbols
 * nor other labels. All lengths are in pixels. Not thread-safe.
 */
final class LabelSpace {

  /**
   * Maximum horizontal and vertical distance between the preferred and the actual place of a label.
   * Decided: by eye.
   */
  private static final int REACH = 56;

  /**
   * Distance between the candidate places of a label. Also the side length of the squares that
   * represent a blocked line.
   */
  private static final int STEP = 4;

  /**
   * The candidate moves of a label, from the shortest to the longest. Of moves of similar length,
   * vertical ones come first.
   */
  private static final List<Point2D> MOVES =
      IntStream.rangeClosed(-REACH / STEP, REACH / STEP)
          .boxed()
          .flatMap(
              y ->
                  IntStream.rangeClosed(-REACH / STEP, REACH / STEP)
                      .mapToObj(x -> new Point2D(x * STEP, y * STEP)))
          .sorted(Comparator.comparingDouble(move -> Math.hypot(1.25 * move.getX(), move.getY())))
          .toList();

  private final List<Rectangle2D> taken = new ArrayList<>();

  /** Frees the areas of all symbols and labels. */
  void clear() {
    taken.clear();
  }

  /** Keeps labels away from a square around a point. */
  void block(Point2D middle, double half) {
    taken.add(square(middle, half));
  }

  /** Keeps labels away from a line. */
  void blockLine(Point2D from, Point2D to) {
    double length = from.distance(to);
    for (double done = 0; done <= length; done += STEP) {
      block(from.interpolate(to, done / length), STEP / 2.0);
    }
  }

  /** Keeps labels away from the rim of a circle, but not from its inside. */
  void blockRim(Point2D middle, double radius) {
    for (double angle = 0; angle < 2 * Math.PI; angle += STEP / radius) {
      block(middle.add(radius * Math.cos(angle), radius * Math.sin(angle)), STEP / 2.0);
    }
  }

  /**
   * Reserves, for a label, the free place nearest to the wanted one.
   *
   * @param within the area that the label must not leave
   * @return the place; empty if there is no free place near the wanted one
   */
  Optional<Rectangle2D> take(Rectangle2D wanted, Rectangle2D within) {
    Rectangle2D start =
        moved(
            wanted,
            inside(wanted.getMinX(), wanted.getMaxX(), within.getMinX(), within.getMaxX()),
            inside(wanted.getMinY(), wanted.getMaxY(), within.getMinY(), within.getMaxY()));
    Rectangle2D reached =
        new Rectangle2D(
            start.getMinX() - REACH,
            start.getMinY() - REACH,
            start.getWidth() + 2 * REACH,
            start.getHeight() + 2 * REACH);
    List<Rectangle2D> near = taken.stream().filter(reached::intersects).toList();
    Optional<Rectangle2D> place =
        MOVES.stream()
            .map(move -> moved(start, move.getX(), move.getY()))
            .filter(within::contains)
            .filter(tried -> near.stream().noneMatch(tried::intersects))
            .findFirst();
    place.ifPresent(taken::add);
    return place;
  }

  /** Returns the shortest distance by which an interval must be moved to lie within another one. */
  private static double inside(double from, double to, double least, double most) {
    return Math.max(0, least - from) - Math.max(0, to - most);
  }

  /** Returns the square around a point. */
  static Rectangle2D square(Point2D middle, double half) {
    return new Rectangle2D(middle.getX() - half, middle.getY() - half, 2 * half, 2 * half);
  }

  private static Rectangle2D moved(Rectangle2D label, double right, double down) {
    return new Rectangle2D(
        label.getMinX() + right, label.getMinY() + down, label.getWidth(), label.getHeight());
  }
}
