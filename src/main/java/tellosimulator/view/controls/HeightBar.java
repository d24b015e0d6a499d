package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.Node;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import tellosimulator.view.text.Messages;

/** The height above the floor as a bar from floor to ceiling. For the JavaFX thread. */
final class HeightBar extends Instrument {

  /** Room for the floor's and the ceiling's number [px]. */
  private static final double MARGIN = 8;

  /** Left edge and width of the bar [px]. */
  private static final double BAR_X = 34;

  private static final double BAR_WIDTH = 9;

  /** Width of everything [px]. */
  private static final double WIDTH = 50;

  /** Numbers that are nearer than this to the ceiling's are left out [px]. */
  private static final double LEAST_GAP = 15;

  private final DoubleProperty heightCm = new SimpleDoubleProperty(this, "heightCm");
  private final DoubleProperty ceilingCm = new SimpleDoubleProperty(this, "ceilingCm", 300);
  private final Messages messages;
  private final double top = MARGIN;
  private final double bottom;
  private final Rectangle track = new Rectangle();
  private final Rectangle filled = new Rectangle();
  private final Polygon pointer = new Polygon(0, 0, 7, -4.5, 7, 4.5);
  private final List<Node> scale = new ArrayList<>();

  /**
   * @param size its height [px]
   */
  HeightBar(Messages messages, double size) {
    super("height-bar", "height-bar", WIDTH, size);
    this.messages = messages;
    this.bottom = size - MARGIN;
    initializeParts();
    layoutParts();
    setupBindings();
    drawScale();
  }

  private void initializeParts() {
    track.setX(BAR_X);
    track.setY(top);
    track.setWidth(BAR_WIDTH);
    track.setHeight(bottom - top);
    track.getStyleClass().add("track");
    filled.setX(BAR_X);
    filled.setWidth(BAR_WIDTH);
    filled.getStyleClass().add("filled");
    pointer.setLayoutX(BAR_X + BAR_WIDTH + 1);
    pointer.getStyleClass().add("pointer");
    List.of(track, filled, pointer).forEach(part -> part.setManaged(false));
  }

  private void layoutParts() {
    getChildren().addAll(track, filled, pointer);
  }

  private void setupBindings() {
    heightCm.addListener((property, before, now) -> draw());
    ceilingCm.addListener((property, before, now) -> drawScale());
  }

  /** Height of the drone's feet above the floor [cm]. */
  DoubleProperty heightCmProperty() {
    return heightCm;
  }

  /** Height of the room [cm]; positive. */
  DoubleProperty ceilingCmProperty() {
    return ceilingCm;
  }

  private void draw() {
    double y = Math.rint(y(heightCm.get()) * 2) / 2; // half a pixel is what can be seen
    filled.setY(y);
    filled.setHeight(bottom - y);
    pointer.setLayoutY(y);
  }

  private void drawScale() {
    getChildren().removeAll(scale);
    scale.clear();
    double ceiling = ceilingCm.get();
    double step = NiceNumber.atLeast(ceiling / 4);
    for (double mark = 0; mark < ceiling; mark += step) {
      if (y(mark) - top >= LEAST_GAP) {
        addMark(mark, mark == 0 ? "surface" : "mark");
      }
    }
    addMark(ceiling, "surface");
    getChildren().addAll(scale);
    draw();
  }

  private void addMark(double cm, String styleClass) {
    double y = y(cm);
    Line line = new Line(BAR_X - 4, y, BAR_X + BAR_WIDTH, y);
    line.getStyleClass().add(styleClass);
    line.setManaged(false);
    Text number = new Text(NumberText.whole(cm));
    number.getStyleClass().add("scale-number");
    scale.add(line);
    scale.add(CenteredText.rightAligned(number, BAR_X - 6, y));
  }

  private double y(double cm) {
    double share = Math.max(0, Math.min(1, cm / ceilingCm.get()));
    return bottom - share * (bottom - top);
  }

  @Override
  String description() {
    return messages.now(
        "height.accessible", NumberText.whole(heightCm.get()), NumberText.whole(ceilingCm.get()));
  }
}
