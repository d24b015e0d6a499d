package tellosimulator.view.world;

import java.util.function.Consumer;
import javafx.geometry.VPos;
import javafx.scene.SnapshotParameters;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.Image;
import javafx.scene.image.PixelWriter;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;

/**
 * The pictures on floor, walls and signs. Sizes in pixels are powers of two, for graphics cards.
 */
final class Pictures {

  static final Color FLOOR = Color.web("#d9d4ca");
  private static final Color FLOOR_LINE = Color.web("#aaa295");
  private static final Color WALL_LOW = Color.web("#cfc9be");
  private static final Color WALL_HIGH = Color.web("#ece8e1");
  private static final Color WALL_LINE = Color.web("#c2bbaf");
  private static final Color SKIRTING = Color.web("#8f877b");

  /** Height of the skirting board [m]. Assumed: as in most rooms. */
  private static final double SKIRTING_HEIGHT = 0.06;

  private static final int TILE = 256;
  private static final int WALL = 1024;
  private static final int SIGN = 256;
  private static final int SHADOW = 64;

  private Pictures() {}

  /**
   * A tile of the floor, its lines through the middle.
   *
   * @param grid edge of the tile [m]
   */
  static Image floorTile(double grid) {
    WritableImage tile = new WritableImage(TILE, TILE);
    PixelWriter writer = tile.getPixelWriter();
    double halfLine = Math.max(1.5, (0.0035 / grid + 0.0075) * TILE);
    for (int x = 0; x < TILE; x++) {
      for (int y = 0; y < TILE; y++) {
        double nearest = Math.min(Math.abs(x + 0.5 - TILE / 2.0), Math.abs(y + 0.5 - TILE / 2.0));
        double line = Math.max(0, Math.min(1, halfLine - nearest + 0.5));
        writer.setColor(x, y, FLOOR.interpolate(FLOOR_LINE, line));
      }
    }
    return tile;
  }

  /**
   * A strip of a wall from floor to ceiling, with a line at each metre.
   *
   * @param height of the room [m]
   * @param shade brightness, 1 as it is
   */
  static Image wall(double height, double shade) {
    int width = 4;
    WritableImage strip = new WritableImage(width, WALL);
    PixelWriter writer = strip.getPixelWriter();
    double pixel = height / WALL;
    for (int y = 0; y < WALL; y++) {
      double above = (WALL - y - 0.5) * pixel;
      Color color = wallColor(above, Math.max(pixel, 0.012));
      Color shaded = color.deriveColor(0, 1, shade, 1);
      for (int x = 0; x < width; x++) {
        writer.setColor(x, y, shaded);
      }
    }
    return strip;
  }

  private static Color wallColor(double above, double line) {
    if (above < SKIRTING_HEIGHT) {
      return SKIRTING;
    }
    double fromMetre = Math.abs(above - Math.rint(above));
    return fromMetre < line / 2
        ? WALL_LINE
        : WALL_LOW.interpolate(WALL_HIGH, Math.min(1, above / 2.5));
  }

  /** A soft round spot. */
  static Image shadow() {
    WritableImage spot = new WritableImage(SHADOW, SHADOW);
    PixelWriter writer = spot.getPixelWriter();
    for (int x = 0; x < SHADOW; x++) {
      for (int y = 0; y < SHADOW; y++) {
        double radius = Math.hypot(x + 0.5 - SHADOW / 2.0, y + 0.5 - SHADOW / 2.0) * 2 / SHADOW;
        double part = Math.max(0, 1 - radius * radius);
        writer.setColor(x, y, Color.gray(0, part * part));
      }
    }
    return spot;
  }

  /** A ring with an arrow upwards, white on nothing. */
  static Image startMark() {
    return drawn(
        SIGN,
        pen -> {
          pen.setStroke(Color.WHITE);
          pen.setLineWidth(12);
          pen.strokeOval(40, 64, 176, 176);
          pen.setLineWidth(5);
          pen.strokeOval(62, 86, 132, 132);
          pen.setFill(Color.WHITE);
          pen.fillPolygon(new double[] {128, 168, 88}, new double[] {4, 54, 54}, 3);
          pen.setLineWidth(14);
          pen.strokeLine(104, 122, 104, 182);
          pen.strokeLine(152, 122, 152, 182);
          pen.strokeLine(104, 152, 152, 152);
        });
  }

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
