package tellosimulator.view.log;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.Event;
import javafx.event.EventTarget;
import javafx.scene.Node;
import javafx.scene.control.IndexedCell;
import javafx.scene.control.ListView;
import javafx.scene.control.ScrollBar;
import javafx.scene.control.skin.VirtualFlow;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/**
 * Keeps the newest line visible until the user scrolls away from it, and resumes once the user
 * scrolls back. Older lines stay in place while they are being read. Confined to the JavaFX thread.
 */
final class AutoScroll {

  private final ListView<?> list;
  private final BooleanProperty following = new SimpleBooleanProperty(true);
  private boolean scrolledByHand;

  /** Starts following the end of a list whose cells all have the same height. */
  AutoScroll(ListView<?> list) {
    this.list = list;
    list.addEventFilter(ScrollEvent.SCROLL, event -> scrolledByHand = true);
    list.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
    list.addEventFilter(MouseEvent.ANY, this::dragged);
    list.heightProperty().addListener((height, before, now) -> toEnd());
    following.addListener((property, before, now) -> toEnd());
  }

  /** Whether the newest line is kept visible. */
  BooleanProperty followingProperty() {
    return following;
  }

  /**
   * Detects whether the user has scrolled away or back. Must be called once per pulse, before lines
   * are added.
   */
  void settle() {
    if (scrolledByHand) {
      scrolledByHand = false;
      following.set(hidden() < list.getFixedCellSize() / 2);
    } else if (following.get() && hidden() > 1) {
      toEnd();
    }
  }

  /**
   * Scrolls to the end while following, and otherwise keeps the visible lines in place. Must be
   * called after lines have been added.
   *
   * @param dropped the number of lines removed at the beginning
   */
  void moveOn(int dropped) {
    VirtualFlow<?> flow = flow();
    if (following.get()) {
      toEnd();
    } else if (dropped > 0 && flow != null) {
      flow.scrollPixels(-dropped * list.getFixedCellSize());
    }
  }

  private void toEnd() {
    if (following.get()) {
      list.scrollTo(list.getItems().size()); // one past the last line is the very end
    }
  }

  /** Returns the total height of the lines below the list's lower edge [px]. */
  private double hidden() {
    VirtualFlow<?> flow = flow();
    IndexedCell<?> last = flow == null ? null : flow.getLastVisibleCell();
    if (last == null) {
      return 0;
    }
    int below = list.getItems().size() - 1 - last.getIndex();
    double cutOff = last.getLayoutY() + last.getHeight() - flow.getHeight();
    return below * list.getFixedCellSize() + Math.max(0, cutOff);
  }

  private void pressed(KeyEvent event) {
    switch (event.getCode()) {
      case UP, DOWN, PAGE_UP, PAGE_DOWN, HOME, END -> scrolledByHand = true;
      default -> {}
    }
  }

  private void dragged(MouseEvent event) {
    boolean held = event.isPrimaryButtonDown() || event.getEventType() == MouseEvent.MOUSE_RELEASED;
    scrolledByHand |= held && onScrollBar(event);
  }

  private static boolean onScrollBar(Event event) {
    EventTarget target = event.getTarget();
    Node node = target instanceof Node touched ? touched : null;
    while (node != null && !(node instanceof ScrollBar)) {
      node = node.getParent();
    }
    return node != null;
  }

  /** Returns the virtual flow of the list; null until the list is shown. */
  private VirtualFlow<?> flow() {
    return list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow ? flow : null;
  }
}
