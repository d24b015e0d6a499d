package tellosimulator.scenery.room;

import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.StrokeFont;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/**
 * A ruler along the edges of the floor. All edges have ticks at each metre, or farther apart in
 * large rooms. Two edges also show the coordinates of the ticks in centimetres, as in commands and
 * scenarios, and the name and direction of the axis. In the window's initial view, the y axis is
 * along the edge nearest to the viewer, and the x axis is along the edge on the right. All numbers
 * have the same orientation, as on a plan: they are upright for a viewer who looks along x, as in
 * the initial view. The ruler is one mesh with one texture.
 */
final class Ruler {

  private static final String CHARACTERS = "0123456789-xy→";

  /** Number of cells in each row and each column of the texture. */
  private static final int CELLS = 4;

  private static final int SIZE = 256;

  /** Index of the filled cell, which is used for the ticks. */
  private static final int FULL = 15;

  private static final int CM_PER_METER = 100;

  /** The reading direction of all numbers, in the room frame. */
  private static final Vec3 RIGHT = new Vec3(0, -1, 0);

  private static final Vec3 UP = new Vec3(1, 0, 0);

  /** Height of a number, as a fraction of the distance between ticks. Decided: by eye. */
  private static final double NUMBER_HEIGHT = 0.19;

  /** Distance between digits, as a fraction of their height. */
  private static final double ADVANCE = 0.62;

  /**
   * Gap between an edge and a number, as a fraction of the number's height. Decided: clear of the
   * tick.
   */
  private static final double GAP = 0.75;

  /**
   * Minimum distance from a corner to the last number, as a fraction of the number's height. It
   * leaves space for the numbers along the other edge.
   */
  private static final double CLEARANCE = GAP + 1.5;

  /** Maximum height of a number, as a fraction of the room's shorter side. Decided: by eye. */
  private static final double LARGEST_NUMBER = 0.07;

  private static final Rgb INK = Rgb.of(0x756b5d);

  /** Colour of the ruler on high-contrast wood. */
  private static final Rgb DARK_INK = Rgb.of(0x1d1812);

  /** A texture atlas of all characters. */
  private static final Texture ON_PLAIN = AlphaMask.texture(SIZE, INK, Ruler::mask);

  private static final Texture ON_WOOD = AlphaMask.texture(SIZE, DARK_INK, Ruler::mask);

  private final double step;
  private final double size;
  private final MeshBuilder mesh = new MeshBuilder();

  private Ruler(Room room) {
    double longest = Math.max(room.depth(), room.width());
    step = step(longest);
    double shortest = Math.min(room.depth(), room.width());
    size = Math.min(NUMBER_HEIGHT * step, LARGEST_NUMBER * shortest);
    for (int side : new int[] {1, -1}) {
      addTicks(new Vec3(side * room.depth() / 2, 0, 0), room.width() / 2);
      addTicks(new Vec3(0, side * room.width() / 2, 0), room.depth() / 2);
    }
    int across = marks(room.width() / 2);
    Vec3 front = new Vec3(-room.depth() / 2, 0, 0);
    addAxis('y', front, new Vec3(0, 1, 0), -across, across);
    int along = marks(room.depth() / 2);
    Vec3 right = new Vec3(0, -room.width() / 2, 0);
    addAxis('x', right, new Vec3(1, 0, 0), 1 - along, along); // skips the first, near the y axis
  }

  /** Returns the ruler of a room, in the room frame. */
  static Part part(Room room, Walls walls) {
    Texture texture = walls == Walls.TEXTURED ? ON_WOOD : ON_PLAIN;
    return new Part(new Ruler(room).mesh.build(), texture, Shading.DECAL);
  }

  /**
   * Returns the distance between ticks [m].
   *
   * @param longest length of the room's longer side [m]
   */
  static double step(double longest) {
    return longest <= 10 ? 1 : longest <= 25 ? 2 : longest <= 60 ? 5 : 10;
  }

  /** Returns the number of ticks on either side of an edge's middle. */
  private int marks(double halfLength) {
    return (int) Math.floor((halfLength - CLEARANCE * size) / step);
  }

  /**
   * Adds ticks along an edge.
   *
   * @param middle middle of the edge
   * @param halfLength half the length of the edge [m]
   */
  private void addTicks(Vec3 middle, double halfLength) {
    Vec3 out = middle.normalized();
    Vec3 right = out.cross(Vec3.UP);
    int most = marks(halfLength);
    for (int i = -most; i <= most; i++) {
      addTick(middle.plusScaled(right, i * step), right, out);
    }
  }

  /**
   * Adds numbers along an edge. Between 0 and the next number, it adds the name of the axis and an
   * arrow.
   *
   * @param middle middle of the edge
   * @param direction direction of the axis
   * @param first index of the first tick with a number, counted from the middle in the direction of
   *     the axis
   * @param last index of the last tick with a number, counted in the same way
   */
  private void addAxis(char name, Vec3 middle, Vec3 direction, int first, int last) {
    Vec3 out = middle.normalized();
    for (int i = first; i <= last; i++) {
      String number = Long.toString(Math.round(i * step * CM_PER_METER));
      addText(number, middle.plusScaled(direction, i * step), out);
    }
    if (last < 1) {
      return; // no space between two numbers
    }
    Vec3 between = middle.plusScaled(direction, step / 2);
    addText(String.valueOf(name), between.plusScaled(direction, -size / 2), out);
    Vec3 arrow = beside(between.plusScaled(direction, size / 2), out, size);
    Vec3 up = Vec3.UP.cross(direction);
    Vec3 foot = arrow.plusScaled(direction, -size / 2).plusScaled(up, -size / 2);
    mesh.quad(new Quad(foot, direction.times(size), up.times(size)), cell(CHARACTERS.indexOf('→')));
  }

  private void addTick(Vec3 mark, Vec3 right, Vec3 out) {
    double width = 0.1 * size;
    Vec3 corner = mark.plusScaled(out, -0.5 * size).plusScaled(right, -width / 2);
    mesh.quad(new Quad(corner, right.times(width), out.times(0.5 * size)), inside(FULL));
  }

  /**
   * Adds a text next to a place at an edge.
   *
   * @param out unit vector that points out of the room, perpendicular to the edge
   */
  private void addText(String text, Vec3 place, Vec3 out) {
    double advance = ADVANCE * size;
    double width = text.length() * advance;
    double extent = Math.abs(out.dot(RIGHT)) * width + Math.abs(out.dot(UP)) * size;
    Vec3 middle = beside(place, out, extent);
    Vec3 foot = middle.plusScaled(UP, -size / 2).plusScaled(RIGHT, -width / 2);
    for (int i = 0; i < text.length(); i++) {
      double left = i * advance - (size - advance) / 2;
      Quad quad = new Quad(foot.plusScaled(RIGHT, left), RIGHT.times(size), UP.times(size));
      mesh.quad(quad, cell(CHARACTERS.indexOf(text.charAt(i))));
    }
  }

  /**
   * Returns the point at which to centre a text or an arrow, so that it is clear of the tick at a
   * place on an edge.
   *
   * @param extent size of the text or arrow perpendicular to the edge [m]
   */
  private Vec3 beside(Vec3 place, Vec3 out, double extent) {
    return place.plusScaled(out, -(GAP * size + extent / 2));
  }

  private static int column(int index) {
    return index % CELLS;
  }

  private static int row(int index) {
    return index / CELLS;
  }

  private static TextureRegion cell(int index) {
    double edge = 1.0 / CELLS;
    return new TextureRegion(column(index) * edge, row(index) * edge, edge, edge);
  }

  /**
   * Returns the inner part of a cell. It excludes the cell's margin, so filters do not blend
   * neighbouring cells.
   */
  private static TextureRegion inside(int index) {
    TextureRegion cell = cell(index);
    double edge = cell.width() / 2;
    return new TextureRegion(cell.left() + edge / 2, cell.top() + edge / 2, edge, edge);
  }

  private static AlphaMask mask() {
    double cell = (double) SIZE / CELLS;
    AlphaMask mask = new AlphaMask(SIZE);
    for (int i = 0; i < CHARACTERS.length(); i++) {
      Point middle = new Point((column(i) + 0.5) * cell, (row(i) + 0.5) * cell);
      StrokeFont.draw(mask, CHARACTERS.charAt(i), middle, 0.64 * cell);
    }
    double left = column(FULL) * cell;
    double top = row(FULL) * cell;
    mask.fill(
        List.of(
            new Point(left, top),
            new Point(left + cell, top),
            new Point(left + cell, top + cell),
            new Point(left, top + cell)));
    return mask;
  }
}
