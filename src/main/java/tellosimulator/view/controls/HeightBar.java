package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/**
 * Shows a drone's height above the floor as a bar on a scale from floor to ceiling. Confined to the
 * JavaFX thread.
 */
final class HeightBar extends Instrument {

  /** Space above and below the bar, for the numbers at the ceiling and the floor [px]. */
  private static final double MARGIN = 8;

  /** Distance of the bar from the left edge of the control [px]. */
  private static final double BAR_X = 34;

  /** Width of the bar [px]. */
  private static final double BAR_WIDTH = 9;

  /** Width of the whole control [px]. */
  private static final double WIDTH = 50;

  /**
   * Minimum distance of a number from the number at the ceiling [px]. Closer numbers are omitted.
   */
  private static final double LEAST_GAP = 15;

  private final Messages messages;
  private final double top = MARGIN;
  private final double bottom;
  private final Rectangle track = Nodes.styled(new Rectangle(), "track");
  private final Rectangle filled = Nodes.styled(new Rectangle(), "filled");
  private final Polygon pointer = Nodes.styled(new Polygon(0, 0, 7, -4.5, 7, 4.5), "pointer");
  private final List<Node> scale = new ArrayList<>();
  private double heightCm;
  private double ceilingCm = 300;

  /**
   * @param size the height [px]
   */
  HeightBar(Messages messages, double size) {
    super("height-bar", "height-bar", WIDTH, size);
    this.messages = messages;
    this.bottom = size - MARGIN;
    initializeParts();
    addShapes(track, filled, pointer);
    drawScale();
  }

  private void initializeParts() {
    track.setX(BAR_X);
    track.setY(top);
    track.setWidth(BAR_WIDTH);
    track.setHeight(bottom - top);
    filled.setX(BAR_X);
    filled.setWidth(BAR_WIDTH);
    pointer.setLayoutX(BAR_X + BAR_WIDTH + 1);
  }

  /**
   * Shows a height.
   *
   * @param newHeightCm the height of the drone's feet above the floor [cm]
   * @param newCeilingCm the height of the room [cm]; positive
   */
  void show(double newHeightCm, double newCeilingCm) {
    heightCm = newHeightCm;
    if (newCeilingCm == ceilingCm) {
      draw();
    } else {
      ceilingCm = newCeilingCm;
      drawScale();
    }
  }

  private void draw() {
    double y = Math.rint(y(heightCm) * 2) / 2; // finer changes are invisible
    filled.setY(y);
    filled.setHeight(bottom - y);
    pointer.setLayoutY(y);
  }

  private void drawScale() {
    getChildren().removeAll(scale);
    scale.clear();
    double step = NiceNumber.atLeast(ceilingCm / 4);
    for (double mark = 0; mark < ceilingCm; mark += step) {
      if (y(mark) - top >= LEAST_GAP) {
        addMark(mark, mark == 0 ? "surface" : "mark");
      }
    }
    addMark(ceilingCm, "surface");
    addShapes(scale.toArray(Node[]::new));
    draw();
  }

  private void addMark(double cm, String styleClass) {
    double y = y(cm);
    Line line = Nodes.styled(new Line(BAR_X - 4, y, BAR_X + BAR_WIDTH, y), styleClass);
    Text number = Nodes.styled(new Text(NumberText.whole(cm)), "scale-number");
    scale.add(line);
    scale.add(CenteredText.rightAligned(number, BAR_X - 6, y));
  }

  private double y(double cm) {
    double share = Math.max(0, Math.min(1, cm / ceilingCm));
    return bottom - share * (bottom - top);
  }

  @Override
  String description() {
    return messages.now(
        "height.accessible", NumberText.whole(heightCm), NumberText.whole(ceilingCm));
  }
}
