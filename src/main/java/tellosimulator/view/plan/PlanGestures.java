package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.scene.Cursor;
import javafx.scene.input.InputEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import tellosimulator.math.Vec3;

/**
 * Handles mouse and keys on the plan: drag, turn, nudge, delete, undo. Dragging the empty floor
 * pans the plan. Confined to the JavaFX thread.
 */
final class PlanGestures {

  /** Distance between the positions to which items snap without Ctrl or Alt [m]. Decided. */
  private static final double GRID_STEP = 0.05;

  private static final double FINE_RASTER = 0.01;

  private static final double TURN = Math.toRadians(15);
  private static final double FINE_TURN = Math.toRadians(1);

  /**
   * Mouse movement up to which a gesture is a click rather than a drag [px]. Decided: tolerates a
   * trembling hand.
   */
  private static final double STILL = 4;

  /** Natural logarithm of the zoom factor per pixel of scrolling. */
  private static final double ZOOM = 0.0025;

  private final PlanEditor editor;
  private final PlanView view;
  private final Actions actions;

  /** Offset from the item's place to the point where the mouse grabbed it [m]. */
  private Vec3 grip = Vec3.ZERO;

  private Vec3 measuredFrom = Vec3.ZERO;
  private boolean dragging;
  private double pressedX;
  private double pressedY;
  private double lastX;
  private double lastY;

  /**
   * The effects that gestures have outside the plan.
   *
   * @param leave closes the plan
   * @param edit opens the properties of the selected item
   * @param measuring whether dragging measures a distance
   */
  record Actions(Runnable leave, Runnable edit, BooleanProperty measuring) {}

  private PlanGestures(PlanEditor editor, PlanView view, Actions actions) {
    this.editor = editor;
    this.view = view;
    this.actions = actions;
  }

  /** Installs the handlers. */
  static void install(PlanEditor editor, PlanView view, Actions actions) {
    PlanGestures gestures = new PlanGestures(editor, view, actions);
    actions.measuring().subscribe(on -> view.show(Optional.<MeasuredDistance>empty()));
    view.setOnMousePressed(gestures::press);
    view.setOnMouseDragged(gestures::drag);
    view.setOnMouseReleased(event -> gestures.letGo());
    view.setOnMouseMoved(gestures::hover);
    view.setOnScroll(gestures::scroll);
    view.setOnKeyPressed(gestures::type);
  }

  private void press(MouseEvent event) {
    view.requestFocus();
    pressedX = event.getX();
    pressedY = event.getY();
    lastX = event.getX();
    lastY = event.getY();
    Optional<PlanItem> item = view.item(event.getX(), event.getY());
    if (actions.measuring().get()) {
      measuredFrom = snapped(under(event), FINE_RASTER);
      view.show(Optional.<MeasuredDistance>empty());
    } else if (event.isPrimaryButtonDown()) {
      select(item, event.isShiftDown());
      item.filter(editor.selection()::contains).ifPresent(held -> grasp(held, event));
      if (event.getClickCount() == 2 && item.isPresent()) {
        actions.edit().run();
      }
    }
    event.consume();
  }

  private void select(Optional<PlanItem> item, boolean more) {
    if (item.isEmpty()) {
      editor.select(more ? editor.selection() : List.of());
    } else if (more) {
      editor.toggle(item.get());
    } else if (editor.selection().contains(item.get())) {
      editor.toggle(item.get()); // adds the item again at the end
      editor.toggle(item.get());
    } else {
      editor.select(List.of(item.get()));
    }
  }

  private void grasp(PlanItem item, MouseEvent event) {
    grip = under(event).minus(editor.plan().placement(item).place()).withZ(0);
    dragging = true;
    editor.hold();
  }

  private void drag(MouseEvent event) {
    if (actions.measuring().get()) {
      Vec3 to = snapped(under(event), FINE_RASTER);
      view.show(Optional.of(new MeasuredDistance(measuredFrom, to)));
    } else if (dragging && Math.hypot(event.getX() - pressedX, event.getY() - pressedY) < STILL) {
      event.consume(); // the panel that opens on selection may move the plan
      return;
    } else if (dragging && editor.selected().isPresent()) {
      pressedX = Double.NEGATIVE_INFINITY;
      Vec3 place = snapped(under(event).minus(grip), free(event) ? FINE_RASTER : GRID_STEP);
      editor.place(now -> now.at(place));
    } else {
      view.show(view.scale().dragged(event.getX() - lastX, event.getY() - lastY));
    }
    lastX = event.getX();
    lastY = event.getY();
    event.consume();
  }

  private void letGo() {
    if (dragging) {
      dragging = false;
      editor.release();
    }
  }

  private void hover(MouseEvent event) {
    boolean over = view.item(event.getX(), event.getY()).isPresent();
    view.setCursor(over ? Cursor.HAND : Cursor.DEFAULT);
  }

  private void scroll(ScrollEvent event) {
    double turned = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
    if (editor.selected().isPresent() && turned != 0) {
      turn(Math.signum(turned) * (free(event) ? FINE_TURN : TURN));
    } else {
      view.show(view.scale().zoomed(Math.exp(turned * ZOOM), event.getX(), event.getY()));
    }
    event.consume();
  }

  private void type(KeyEvent event) {
    boolean done = (event.isShortcutDown() && command(event)) || key(event);
    if (done) {
      event.consume();
    }
  }

  private boolean command(KeyEvent event) {
    boolean again =
        event.getCode() == KeyCode.Y || (event.getCode() == KeyCode.Z && event.isShiftDown());
    if (again) {
      editor.redo();
      return true;
    }
    switch (event.getCode()) {
      case Z -> editor.undo();
      case D -> new PlanAdditions(editor).duplicate();
      case A -> editor.select(editor.plan().items());
      default -> {
        return false;
      }
    }
    return true;
  }

  private boolean key(KeyEvent event) {
    double step = free(event) ? FINE_RASTER : GRID_STEP;
    switch (event.getCode()) {
      case DELETE, BACK_SPACE -> editor.remove();
      case R -> turn((event.isShiftDown() ? -1 : 1) * (free(event) ? FINE_TURN : TURN));
      case UP -> nudge(new Vec3(step, 0, 0));
      case DOWN -> nudge(new Vec3(-step, 0, 0));
      case LEFT -> nudge(new Vec3(0, step, 0));
      case RIGHT -> nudge(new Vec3(0, -step, 0));
      case ENTER -> actions.edit().run();
      case M -> actions.measuring().set(!actions.measuring().get());
      case ESCAPE -> escape();
      default -> {
        return false;
      }
    }
    return true;
  }

  private void escape() {
    if (actions.measuring().get()) {
      actions.measuring().set(false);
    } else if (editor.selected().isPresent()) {
      editor.select(List.of());
    } else {
      actions.leave().run();
    }
  }

  private void nudge(Vec3 step) {
    editor.place(now -> now.at(now.place().plus(step)));
  }

  /** Turns the selected item to the next multiple of the angle. */
  private void turn(double angle) {
    editor.place(now -> now.turnedTo(Math.rint(now.heading() / angle + 1) * angle));
  }

  private Vec3 under(MouseEvent event) {
    return view.scale().place(event.getX(), event.getY());
  }

  private static Vec3 snapped(Vec3 place, double raster) {
    return new Vec3(
        Math.rint(place.x() / raster) * raster, Math.rint(place.y() / raster) * raster, 0);
  }

  /** Returns whether a modifier key switches to the fine grid. */
  private static boolean free(InputEvent event) {
    if (event instanceof MouseEvent mouse) {
      return mouse.isControlDown() || mouse.isAltDown();
    } else if (event instanceof ScrollEvent scroll) {
      return scroll.isControlDown() || scroll.isAltDown();
    }
    return event instanceof KeyEvent key && (key.isControlDown() || key.isAltDown());
  }
}
