package tellosimulator.view.world;

import javafx.geometry.Rectangle2D;
import javafx.geometry.VPos;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;
import tellosimulator.math.Vec3;
import tellosimulator.view.world.Quads.Quad;
import tellosimulator.world.Room;

/**
 * Ticks and numbers along the edges of the floor, in metres of the room frame: y along the front
 * and the back edge, x along the sides. One mesh on one picture.
 */
final class MetreMarks {

  private static final String SIGNS = "0123456789-";

  /** Cells of the picture in a row and in a column. */
  private static final int CELLS = 4;

  private static final int PICTURE = 256;

  /** The cell that is full, of which ticks are made. */
  private static final int FULL = 15;

  /** Height of a number, as a part of the distance from mark to mark. Decided: by eye. */
  private static final double NUMBER_HEIGHT = 0.19;

  /** The same, as a part of the room's shorter edge. Decided: by eye. */
  private static final double LARGEST_NUMBER = 0.07;

  private static final Color INK = Color.web("#6f675b");

  private final double step;
  private final double size;
  private final Quads quads = new Quads();

  private MetreMarks(Room room) {
    double longest = Math.max(room.depth(), room.width());
    step = step(longest);
    double shortest = Math.min(room.depth(), room.width());
    size = Math.min(NUMBER_HEIGHT * step, LARGEST_NUMBER * shortest);
    for (int side : new int[] {1, -1}) {
      addEdge(new Vec3(side * room.depth() / 2, 0, 0), room.width() / 2);
      addEdge(new Vec3(0, side * room.width() / 2, 0), room.depth() / 2);
    }
  }

  static TriangleMesh mesh(Room room) {
    return new MetreMarks(room).quads.mesh();
  }

  /** Metres from mark to mark in a room of some length [m]. */
  static double step(double longest) {
    return longest <= 10 ? 1 : longest <= 25 ? 2 : longest <= 60 ? 5 : 10;
  }

  /**
   * Marks along an edge.
   *
   * @param middle of the edge; the numbers stand upright for who looks towards it from inside
   * @param halfLength of the edge [m]
   */
  private void addEdge(Vec3 middle, double halfLength) {
    Vec3 out = middle.normalized();
    Vec3 right = out.cross(Vec3.UP);
    boolean alongX = Math.abs(right.x()) > 0.5;
    int most = (int) Math.floor((halfLength - size) / step);
    for (int i = -most; i <= most; i++) {
      Vec3 along = alongX ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0);
      Vec3 mark = middle.plusScaled(along, i * step);
      addTick(mark, right, out);
      addNumber(Math.round(i * step), mark.plusScaled(out, -1.75 * size), right, out);
    }
  }

  private void addTick(Vec3 mark, Vec3 right, Vec3 out) {
    double width = 0.1 * size;
    Vec3 corner = mark.plusScaled(out, -0.5 * size).plusScaled(right, -width / 2);
    quads.add(new Quad(corner, right.times(width), out.times(0.5 * size)), inside(FULL));
  }

  private void addNumber(long value, Vec3 foot, Vec3 right, Vec3 up) {
    String text = Long.toString(value);
    double advance = 0.62 * size;
    for (int i = 0; i < text.length(); i++) {
      double left = (i - text.length() / 2.0) * advance - (size - advance) / 2;
      Quad quad = new Quad(foot.plusScaled(right, left), right.times(size), up.times(size));
      quads.add(quad, cell(SIGNS.indexOf(text.charAt(i))));
    }
  }

  private static int column(int index) {
    return index % CELLS;
  }

  private static int row(int index) {
    return index / CELLS;
  }

  private static Rectangle2D cell(int index) {
    double edge = 1.0 / CELLS;
    return new Rectangle2D(column(index) * edge, row(index) * edge, edge, edge);
  }

  /** A part of a cell that is far from its neighbours. */
  private static Rectangle2D inside(int index) {
    Rectangle2D cell = cell(index);
    double edge = cell.getWidth() / 2;
    return new Rectangle2D(cell.getMinX() + edge / 2, cell.getMinY() + edge / 2, edge, edge);
  }

  static Image picture() {
    double cell = (double) PICTURE / CELLS;
    return Pictures.drawn(
        PICTURE,
        pen -> {
          pen.setFill(INK);
          pen.setFont(Font.font("System", FontWeight.BOLD, cell * 0.85));
          pen.setTextAlign(TextAlignment.CENTER);
          pen.setTextBaseline(VPos.CENTER);
          for (int i = 0; i < SIGNS.length(); i++) {
            double x = (column(i) + 0.5) * cell;
            double y = (row(i) + 0.5) * cell;
            pen.fillText(SIGNS.substring(i, i + 1), x, y);
          }
          pen.fillRect(column(FULL) * cell, row(FULL) * cell, cell, cell);
        });
  }
}
