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

/**
 * Ticks each metre or more along the edges of the floor, and at two of them their places in
 * centimetres, as commands and scenarios count, with the axis's name and direction: y along the
 * edge that is in front in the start view, x along the one at its right. All numbers stand as on a
 * plan, upright for someone who looks along x, as in the start view. One mesh with one texture.
 */
final class MeterMarks {

  private static final String CHARACTERS = "0123456789-xy→";

  /** Cells of the texture in a row and in a column. */
  private static final int CELLS = 4;

  private static final int SIZE = 256;

  /** The cell that is filled, for the ticks. */
  private static final int FULL = 15;

  private static final int CM_PER_METER = 100;

  /** The direction in which all numbers are read, and the one that is up for them, room frame. */
  private static final Vec3 RIGHT = new Vec3(0, -1, 0);

  private static final Vec3 UP = new Vec3(1, 0, 0);

  /** Height of a number, as a part of the distance from mark to mark. Decided: by eye. */
  private static final double NUMBER_HEIGHT = 0.19;

  /** From one digit to the next, as a part of their height. */
  private static final double ADVANCE = 0.62;

  /** From the edge to a number, as a part of its height. Decided: clear of the tick. */
  private static final double GAP = 0.75;

  /** From a corner to the last number, in the same: beside those of the other edge. */
  private static final double CLEARANCE = GAP + 1.5;

  /** The same, as a part of the room's shorter edge. Decided: by eye. */
  private static final double LARGEST_NUMBER = 0.07;

  private static final Rgb INK = Rgb.of(0x756b5d);

  /** On wood with much contrast. */
  private static final Rgb DARK_INK = Rgb.of(0x1d1812);

  /** A texture atlas of all characters. */
  private static final Texture ON_PLAIN = AlphaMask.texture(SIZE, INK, MeterMarks::mask);

  private static final Texture ON_WOOD = AlphaMask.texture(SIZE, DARK_INK, MeterMarks::mask);

  private final double step;
  private final double size;
  private final MeshBuilder mesh = new MeshBuilder();

  private MeterMarks(Room room) {
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
    addAxis('x', right, new Vec3(1, 0, 0), 1 - along, along); // the first is at the y axis
  }

  /** The marks of a room, room frame. */
  static Part part(Room room, Finish finish) {
    Texture texture = finish == Finish.TEXTURED ? ON_WOOD : ON_PLAIN;
    return new Part(new MeterMarks(room).mesh.build(), texture, Shading.DECAL);
  }

  /** Metres from mark to mark in a room of some length [m]. */
  static double step(double longest) {
    return longest <= 10 ? 1 : longest <= 25 ? 2 : longest <= 60 ? 5 : 10;
  }

  /** How many marks there are on each side of an edge's middle. */
  private int marks(double halfLength) {
    return (int) Math.floor((halfLength - CLEARANCE * size) / step);
  }

  /**
   * Ticks along an edge.
   *
   * @param middle of the edge
   * @param halfLength of the edge [m]
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
   * Numbers along an edge, and between 0 and the next one the name of the axis and an arrow.
   *
   * @param middle of the edge
   * @param direction of the axis
   * @param first mark from the middle, along the direction
   * @param last the same
   */
  private void addAxis(char name, Vec3 middle, Vec3 direction, int first, int last) {
    Vec3 out = middle.normalized();
    for (int i = first; i <= last; i++) {
      String number = Long.toString(Math.round(i * step * CM_PER_METER));
      addText(number, middle.plusScaled(direction, i * step), out);
    }
    if (last < 1) {
      return; // there is no room between two numbers
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
   * A text beside its place at an edge.
   *
   * @param out from the room through the edge
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
   * The middle of what is clear of the tick at a place of an edge.
   *
   * @param extent away from the edge [m]
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

  /** A part of a cell that is far from its neighbours. */
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
