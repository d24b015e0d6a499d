package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntFunction;
import javafx.scene.AccessibleRole;
import javafx.scene.canvas.Canvas;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.words.Phrase;

/** The plan itself: all that is in the room, seen from above. For the JavaFX thread. */
final class PlanView extends Region {

  /** How far beside an item the mouse still catches it [px]. */
  private static final double CATCH = 4;

  private final PlanEditor editor;
  private final Canvas canvas = new Canvas();

  /** Lies around it while the keyboard is here. */
  private final Region ring = new Region();

  private final PlanPainter painter;
  private PlanViewport scale;
  private Optional<MeasuredDistance> measured = Optional.empty();

  /** Whether all of the room is to be seen, whatever becomes of it. */
  private boolean whole = true;

  private boolean stale = true;
  private PlanPainter.Remarks remarks = PlanPainter.Remarks.NONE;

  /**
   * @param colors gives that of the drone of a number
   * @param said puts names into the language of the window
   */
  PlanView(PlanEditor editor, IntFunction<Color> colors, Function<Phrase, String> said) {
    this.editor = editor;
    this.painter = new PlanPainter(canvas.getGraphicsContext2D(), colors, said);
    this.scale = PlanViewport.whole(editor.plan().arena().room(), 1, 1);
    setId("plan");
    getStyleClass().add("plan");
    setMinSize(0, 0);
    setFocusTraversable(true);
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    ring.getStyleClass().add("ring");
    ring.setMouseTransparent(true);
    ring.setManaged(false);
    getChildren().addAll(canvas, ring);
    editor.planProperty().addListener((property, before, now) -> stale = true);
    editor.selectionProperty().addListener((property, before, now) -> stale = true);
    editor.problemProperty().addListener((property, before, now) -> stale = true);
  }

  /** Draws it anew if something has changed. */
  void advance(PlanPainter.Remarks newest) {
    stale |= !newest.equals(remarks);
    remarks = newest;
    PlanViewport wanted =
        whole
            ? PlanViewport.whole(editor.plan().arena().room(), getWidth(), getHeight())
            : scale.sized(getWidth(), getHeight());
    if (stale || !wanted.equals(scale)) {
      scale = wanted;
      stale = false;
      painter.paint(editor.plan(), scale, remarks);
      boolean wrong = editor.problemProperty().get().isPresent();
      editor.selection().stream()
          .filter(editor.plan()::has)
          .forEach(item -> painter.mark(editor.plan(), item, wrong));
      measured.ifPresent(painter::paint);
    }
  }

  /** The part of the room that is shown; empty for all of it. */
  Optional<PlanViewport> part() {
    return whole ? Optional.empty() : Optional.of(scale);
  }

  PlanViewport scale() {
    return scale;
  }

  /** Shows another part of the room. */
  void show(PlanViewport newScale) {
    whole = false;
    scale = newScale;
    stale = true;
  }

  /** Shows a distance, or none. */
  void show(Optional<MeasuredDistance> newMeasured) {
    measured = newMeasured;
    stale = true;
  }

  /** Shows all of the room. */
  void showWhole() {
    whole = true;
  }

  /** The uppermost item at a point of the screen. */
  Optional<PlanItem> item(double x, double y) {
    FloorPlan plan = editor.plan();
    Optional<PlanItem> tagged =
        MarkPainter.tagged(remarks.goals(), scale, x, y)
            .map(mark -> (PlanItem) new GoalItem(mark.number() - 1))
            .filter(plan::has);
    if (tagged.isPresent()) {
      return tagged;
    }
    Vec3 place = scale.place(x, y);
    List<PlanItem> items = plan.items();
    for (int i = items.size() - 1; i >= 0; i--) {
      PlanItem item = items.get(i);
      boolean named = item instanceof GoalItem goal && !(plan.goal(goal) instanceof Goal.InRegion);
      if (!named // the gate or pad is there itself
          && plan.outline(item).covers(place, plan.placement(item), scale.meters(CATCH))) {
        return Optional.of(item);
      }
    }
    return Optional.empty();
  }

  @Override
  protected void layoutChildren() {
    ring.resizeRelocate(0, 0, getWidth(), getHeight());
    if (canvas.getWidth() != getWidth() || canvas.getHeight() != getHeight()) {
      canvas.setWidth(getWidth());
      canvas.setHeight(getHeight());
      stale = true;
    }
  }
}
