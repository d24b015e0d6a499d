package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Rectangle2D;

/** Where labels are on the plan, so that none is written over another. Not thread-safe. */
final class LabelSpace {

  /** How often a label is moved down by its height; then it is written there all the same. */
  private static final int MOST_MOVES = 6;

  private final List<Rectangle2D> taken = new ArrayList<>();

  /** All labels are gone. */
  void clear() {
    taken.clear();
  }

  /**
   * Takes the first free place for a label, at its own place or below it.
   *
   * @param label where it should be [px]
   * @return how far below that it is [px]
   */
  double take(Rectangle2D label) {
    Rectangle2D place = label;
    for (int move = 0; move < MOST_MOVES && taken.stream().anyMatch(place::intersects); move++) {
      place =
          new Rectangle2D(
              label.getMinX(),
              place.getMinY() + label.getHeight(),
              label.getWidth(),
              label.getHeight());
    }
    taken.add(place);
    return place.getMinY() - label.getMinY();
  }
}
