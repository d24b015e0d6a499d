package tellosimulator.view.plan;

import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;
import tellosimulator.math.Frames;

/** What is written on the plan, all of it in bold. For the JavaFX thread. */
final class PlanLabels {

  /** Usual size of text [px]. */
  static final double SIZE = 12;

  static final Color INK = Color.web("#2b2b2b");

  /** The color of the floor, a little of which is around what is written on things. */
  private static final Color HALO = Color.web("#f4f0e8", 0.75);

  private final GraphicsContext pen;

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

  /** Writes what can be read on everything. */
  void writeInFront(String text, double x, double y, TextAlignment alignment) {
    prepare(SIZE, alignment);
    pen.setStroke(HALO);
    pen.setLineWidth(3);
    pen.strokeText(text, x, y);
    pen.setFill(INK);
    pen.fillText(text, x, y);
  }

  private void prepare(double size, TextAlignment alignment) {
    pen.setFont(Font.font("System", FontWeight.BOLD, size));
    pen.setTextAlign(alignment);
    pen.setTextBaseline(VPos.CENTER);
  }
}
