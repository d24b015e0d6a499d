package tellosimulator.view.world;

import java.util.function.Consumer;
import javafx.geometry.VPos;
import javafx.scene.SnapshotParameters;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;

/**
 * The pictures on floor, walls and signs. Sizes in pixels are powers of two, for graphics cards.
 */
final class Pictures {

  private Pictures() {}

  /** A drone's number on a disc of its colour. */
  static Image number(int number, Color color) {
    return drawn(
        64,
        pen -> {
          pen.setFill(Color.WHITE);
          pen.fillOval(1, 1, 62, 62);
          pen.setFill(color);
          pen.fillOval(4, 4, 56, 56);
          write(pen, Integer.toString(number), number < 10 ? 44 : 32);
        });
  }

  private static void write(GraphicsContext pen, String text, double size) {
    pen.setFill(Color.WHITE);
    pen.setFont(Font.font("System", FontWeight.BOLD, size));
    pen.setTextAlign(TextAlignment.CENTER);
    pen.setTextBaseline(VPos.CENTER);
    pen.fillText(text, 32, 32);
  }

  /** What a pen draws on a transparent square. */
  static Image drawn(int size, Consumer<GraphicsContext> drawing) {
    Canvas canvas = new Canvas(size, size);
    drawing.accept(canvas.getGraphicsContext2D());
    SnapshotParameters transparent = new SnapshotParameters();
    transparent.setFill(Color.TRANSPARENT);
    return canvas.snapshot(transparent, null);
  }
}
