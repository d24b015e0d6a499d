package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import javafx.beans.value.ObservableValue;
import javafx.scene.canvas.Canvas;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import tellosimulator.math.Vec3;

/** The plan itself: all that is in the room, seen from above. For the JavaFX thread. */
final class PlanView extends Region {

  /** How far beside a piece the mouse still catches it [px]. */
  private static final double CATCH = 4;

  private final PlanEditor editor;
  private final ObservableValue<String> front;
  private final Canvas canvas = new Canvas();
  private final PlanPainter painter;
  private PlanScale scale;

  /** Whether all of the room is to be seen, whatever becomes of it. */
  private boolean whole = true;

  private boolean stale = true;

  /**
   * @param colors gives that of the drone of a number
   * @param front what is written at the front wall
   */
  PlanView(PlanEditor editor, IntFunction<Color> colors, ObservableValue<String> front) {
    this.editor = editor;
    this.painter = new PlanPainter(canvas.getGraphicsContext2D(), colors);
    this.front = front;
    this.scale = PlanScale.whole(editor.layout().arena().room(), 1, 1);
    setId("plan");
    getStyleClass().add("plan");
    setMinSize(0, 0);
    setFocusTraversable(true);
    getChildren().add(canvas);
    editor.layoutProperty().addListener((property, before, now) -> stale = true);
    editor.selectedProperty().addListener((property, before, now) -> stale = true);
    front.addListener((property, before, now) -> stale = true);
    editor.problemProperty().addListener((property, before, now) -> stale = true);
  }

  /** Draws it anew if something has changed. */
  void advance() {
    PlanScale wanted =
        whole
            ? PlanScale.whole(editor.layout().arena().room(), getWidth(), getHeight())
            : scale.sized(getWidth(), getHeight());
    if (stale || !wanted.equals(scale)) {
      scale = wanted;
      stale = false;
      painter.paint(editor.layout(), scale, front.getValue());
      editor
          .selected()
          .filter(editor.layout()::has)
          .ifPresent(
              piece ->
                  painter.mark(editor.layout(), piece, editor.problemProperty().get().isPresent()));
    }
  }

  PlanScale scale() {
    return scale;
  }

  /** Shows another part of the room. */
  void show(PlanScale newScale) {
    whole = false;
    scale = newScale;
    stale = true;
  }

  /** Shows all of the room. */
  void showWhole() {
    whole = true;
  }

  /** The uppermost piece at a point of the screen. */
  Optional<Piece> piece(double x, double y) {
    Layout layout = editor.layout();
    Vec3 place = scale.place(x, y);
    List<Piece> pieces = layout.pieces();
    for (int i = pieces.size() - 1; i >= 0; i--) {
      Piece piece = pieces.get(i);
      if (layout.outline(piece).covers(place, layout.spot(piece), scale.metres(CATCH))) {
        return Optional.of(piece);
      }
    }
    return Optional.empty();
  }

  @Override
  protected void layoutChildren() {
    if (canvas.getWidth() != getWidth() || canvas.getHeight() != getHeight()) {
      canvas.setWidth(getWidth());
      canvas.setHeight(getHeight());
      stale = true;
    }
  }
}
