package tellosimulator.view.plan;

import java.util.Optional;
import javafx.geometry.Rectangle2D;
import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.Text;
import javafx.scene.text.TextAlignment;
import tellosimulator.math.Frames;

/** Draws the texts of the plan, all in bold. Confined to the JavaFX thread. */
final class PlanLabels {

  /** Default font size [px]. */
  static final double SIZE = 12;

  static final Color INK = Color.web("#2b2b2b");

  /**
   * Colour of the plates behind labels: the colour of the floor, but translucent. Decided: opaque
   * enough that, even on black, the contrast with {@link #INK} is at least 7:1.
   */
  private static final Color PLATE = Color.web("#f4f0e8", 0.8);

  /** Height of a plate [px]. */
  private static final double LINE = 14;

  /** Margin of a plate on either side of the text [px]. */
  private static final double MARGIN = 3;

  private final GraphicsContext pen;
  private final LabelSpace space = new LabelSpace();
  private Rectangle2D walls = Rectangle2D.EMPTY;

  PlanLabels(GraphicsContext pen) {
    this.pen = pen;
  }

  /** Formats a length in centimetres. */
  static String centimeters(double meters) {
    return Long.toString(Math.round(Frames.centimeters(meters)));
  }

  /** Formats a height in centimetres. */
  static String height(double meters) {
    return "z " + centimeters(meters);
  }

  /** Draws centred text in the current colour. */
  void write(String text, double x, double y, double size) {
    prepare(size);
    pen.fillText(text, x, y);
  }

  /**
   * Frees the space of all labels before the plan is redrawn.
   *
   * @param newWalls the area inside the walls, which new labels must not leave [px]
   */
  void clear(Rectangle2D newWalls) {
    space.clear();
    walls = newWalls;
  }

  /** Returns the space in which labels are placed. */
  LabelSpace space() {
    return space;
  }

  /**
   * Draws one of several texts near a point: the first one for which there is space. A plate makes
   * the text readable on any background. Draws nothing if there is no space for any of them.
   */
  void writeInFront(double x, double y, String... texts) {
    prepare(SIZE);
    for (String text : texts) {
      Text measured = new Text(text);
      measured.setFont(pen.getFont());
      double width = measured.getLayoutBounds().getWidth() + 2 * MARGIN;
      Optional<Rectangle2D> place =
          space.take(new Rectangle2D(x - width / 2, y - LINE / 2, width, LINE), walls);
      if (place.isPresent()) {
        Rectangle2D plate = place.get();
        pen.setFill(PLATE);
        pen.fillRoundRect(plate.getMinX(), plate.getMinY(), width, LINE, 6, 6);
        pen.setFill(INK);
        pen.fillText(text, plate.getMinX() + width / 2, plate.getMinY() + LINE / 2);
        return;
      }
    }
  }

  private void prepare(double size) {
    pen.setFont(Font.font("System", FontWeight.BOLD, size));
    pen.setTextAlign(TextAlignment.CENTER);
    pen.setTextBaseline(VPos.CENTER);
  }
}
