package tellosimulator.view.plan;

import javafx.geometry.Rectangle2D;
import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.Text;
import javafx.scene.text.TextAlignment;
import tellosimulator.math.Frames;

/** What is written on the plan, all of it in bold. For the JavaFX thread. */
final class PlanLabels {

  /** Usual size of text [px]. */
  static final double SIZE = 12;

  static final Color INK = Color.web("#2b2b2b");

  /** The color of the floor, a little of which is around what is written on things. */
  private static final Color HALO = Color.web("#f4f0e8", 0.75);

  /** Height of a line [px]. */
  private static final double LINE = 14;

  private final GraphicsContext pen;
  private final LabelSpace space = new LabelSpace();
  private double left;
  private double right = Double.MAX_VALUE;

  PlanLabels(GraphicsContext pen) {
    this.pen = pen;
  }

  /** A length as on the plan [cm]. */
  static String centimeters(double meters) {
    return Long.toString(Math.round(Frames.centimeters(meters)));
  }

  /** A height as on the plan. */
  static String height(double meters) {
    return "z " + centimeters(meters);
  }

  /** Writes in the present color, with its middle at a point. */
  void write(String text, double x, double y, double size) {
    prepare(size, TextAlignment.CENTER);
    pen.fillText(text, x, y);
  }

  /** Begins a drawing without labels, which must be between the walls at the left and right. */
  void clear(double newLeft, double newRight) {
    space.clear();
    left = newLeft;
    right = newRight;
  }

  /** Writes what can be read on everything, below what is written there already. */
  void writeInFront(String text, double wantedX, double wantedY, TextAlignment alignment) {
    prepare(SIZE, alignment);
    Rectangle2D wanted = bounds(text, wantedX, wantedY, alignment);
    double aside = Math.max(0, left - wanted.getMinX()) - Math.max(0, wanted.getMaxX() - right);
    double x = wantedX + aside;
    double y = wantedY + space.take(bounds(text, x, wantedY, alignment));
    pen.setStroke(HALO);
    pen.setLineWidth(3);
    pen.strokeText(text, x, y);
    pen.setFill(INK);
    pen.fillText(text, x, y);
  }

  private Rectangle2D bounds(String text, double x, double y, TextAlignment alignment) {
    Text measured = new Text(text);
    measured.setFont(pen.getFont());
    double width = measured.getLayoutBounds().getWidth();
    double start = alignment == TextAlignment.CENTER ? x - width / 2 : x;
    return new Rectangle2D(start, y - LINE / 2, width, LINE);
  }

  private void prepare(double size, TextAlignment alignment) {
    pen.setFont(Font.font("System", FontWeight.BOLD, size));
    pen.setTextAlign(alignment);
    pen.setTextBaseline(VPos.CENTER);
  }
}
