package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntFunction;
import javafx.scene.AccessibleRole;
import javafx.scene.canvas.Canvas;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.words.Phrase;

/** The drawing of the room and its items, seen from above. Confined to the JavaFX thread. */
final class PlanView extends Region {

  /** Distance from an item within which the mouse still hits it [px]. */
  private static final double CATCH = 4;

  private final PlanEditor editor;
  private final Canvas canvas = new Canvas();

  /** The focus ring. */
  private final Region ring = new Region();

  private final PlanPainter painter;
  private PlanViewport scale;
  private Optional<MeasuredDistance> measured = Optional.empty();

  /** Whether the whole room stays in view, even if the room or the view is resized. */
  private boolean whole = true;

  private boolean stale = true;
  private PlanPainter.Remarks remarks = PlanPainter.Remarks.NONE;

  /**
   * Creates a view.
   *
   * @param colors returns the colour of a drone, given its number
   * @param said translates a phrase into the window's language
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

  /** Redraws the plan if something has changed. */
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
      List<PlanItem> selected = editor.selection().stream().filter(editor.plan()::has).toList();
      selected.forEach(item -> painter.mark(editor.plan(), item, wrong));
      measured.ifPresent(painter::paint);
      painter.label(editor.plan(), selected);
    }
  }

  /** Returns the visible part of the room; empty for the whole room. */
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

  /** Shows a measured distance; empty hides it. */
  void show(Optional<MeasuredDistance> newMeasured) {
    measured = newMeasured;
    stale = true;
  }

  /** Shows the whole room. */
  void showWhole() {
    whole = true;
  }

  /** Returns the topmost item at a point of the view [px]. */
  Optional<PlanItem> item(double x, double y) {
    FloorPlan plan = editor.plan();
    Optional<PlanItem> tagged =
        painter
            .tagged(x, y)
            .map(mark -> (PlanItem) new GoalItem(mark.number() - 1))
            .filter(plan::has);
    if (tagged.isPresent()) {
      return tagged;
    }
    Vec3 place = scale.place(x, y);
    List<PlanItem> items = plan.items();
    for (int i = items.size() - 1; i >= 0; i--) {
      PlanItem item = items.get(i);
      if (!plan.namesAnother(item) // the gate or pad itself is hit instead
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
