package tellosimulator.scenery.paint;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;

/**
 * A drawing in one ink on nothing. Places are in pixels, from the left and from the top. Its edges
 * are smooth: how much ink a pixel gets hangs on the distance of its middle from the edge. For one
 * thread.
 */
public final class Sketch {

  /** A place: pixels from the left and from the top. */
  public record Point(double x, double y) {}

  /** A part of an ellipse; angles in radians, from the right downwards. */
  public record Arc(Point middle, Point radii, double from, double to) {

    /** Decided: no corner can be seen at 256 pixels. */
    private static final int PARTS_OF_TURN = 48;

    /** The whole circle. */
    public static Arc circle(Point middle, double radius) {
      return new Arc(middle, new Point(radius, radius), 0, 2 * Math.PI);
    }

    /** Points on it, from one end to the other. */
    public List<Point> points() {
      int parts = (int) Math.ceil(Math.abs(to - from) / (2 * Math.PI) * PARTS_OF_TURN);
      List<Point> points = new ArrayList<>();
      for (int i = 0; i <= parts; i++) {
        double angle = from + (to - from) * i / parts;
        points.add(
            new Point(
                middle.x + radii.x * StrictMath.cos(angle),
                middle.y + radii.y * StrictMath.sin(angle)));
      }
      return points;
    }
  }

  private final int size;
  private final double[] ink;

  /**
   * @param size edge of the square sheet [pixels]
   */
  public Sketch(int size) {
    this.size = size;
    ink = new double[size * size];
  }

  /**
   * A stroke with round ends.
   *
   * @param way its middle, from point to point
   * @param width of the stroke [pixels]
   */
  public Sketch stroke(List<Point> way, double width) {
    for (int i = 1; i < way.size(); i++) { // piece by piece: each touches only a few pixels
      stroke(way.get(i - 1), way.get(i), width / 2);
    }
    return this;
  }

  /** A surface between straight edges, the last of which leads back to the first corner. */
  public Sketch fill(List<Point> corners) {
    List<Point> outline = new ArrayList<>(corners);
    outline.add(corners.get(0));
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (Point corner : corners) {
      left = Math.min(left, corner.x);
      right = Math.max(right, corner.x);
      top = Math.min(top, corner.y);
      bottom = Math.max(bottom, corner.y);
    }
    for (int y = first(top); y <= last(bottom); y++) {
      for (int x = first(left); x <= last(right); x++) {
        double edge = distance(outline, x + 0.5, y + 0.5);
        soak(x, y, inside(outline, x + 0.5, y + 0.5) ? edge : -edge);
      }
    }
    return this;
  }

  /** What was drawn, in an ink. */
  public Texture texture(Rgb color) {
    int[] pixels = new int[ink.length];
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = color.argb(ink[i]);
    }
    return new Texture(size, size, pixels);
  }

  /** Prints what was drawn in an ink over the pixels of a sheet of the same size. */
  void print(Rgb color, int[] pixels) {
    for (int i = 0; i < pixels.length; i++) {
      if (ink[i] > 0) {
        pixels[i] = Rgb.of(pixels[i]).towards(color, ink[i]).argb();
      }
    }
  }

  /** A round spot. */
  public Sketch dot(Point middle, double radius) {
    return stroke(List.of(middle, middle), 2 * radius);
  }

  private void stroke(Point from, Point to, double radius) {
    int bottom = last(Math.max(from.y, to.y) + radius);
    int left = first(Math.min(from.x, to.x) - radius);
    int right = last(Math.max(from.x, to.x) + radius);
    for (int y = first(Math.min(from.y, to.y) - radius); y <= bottom; y++) {
      for (int x = left; x <= right; x++) {
        soak(x, y, radius - distance(from, to, x + 0.5, y + 0.5));
      }
    }
  }

  /**
   * Gives a pixel ink.
   *
   * @param within how far its middle lies within the edge [pixels]
   */
  private void soak(int x, int y, double within) {
    double wet = Math.max(0, Math.min(1, within + 0.5));
    ink[y * size + x] = Math.max(ink[y * size + x], wet);
  }

  /** The first pixel that an edge may touch. */
  private static int first(double edge) {
    return (int) Math.max(0, Math.floor(edge) - 1);
  }

  private int last(double edge) {
    return (int) Math.min(size - 1, Math.ceil(edge) + 1);
  }

  private static double distance(List<Point> way, double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 1; i < way.size(); i++) {
      nearest = Math.min(nearest, distance(way.get(i - 1), way.get(i), x, y));
    }
    return nearest;
  }

  private static double distance(Point from, Point to, double x, double y) {
    double dx = to.x - from.x;
    double dy = to.y - from.y;
    double squared = dx * dx + dy * dy;
    double along = squared == 0 ? 0 : ((x - from.x) * dx + (y - from.y) * dy) / squared;
    double within = Math.max(0, Math.min(1, along));
    double asideX = x - (from.x + dx * within);
    double asideY = y - (from.y + dy * within);
    return Math.sqrt(asideX * asideX + asideY * asideY);
  }

  /** Whether a ray to the right crosses the outline an odd number of times. */
  private static boolean inside(List<Point> outline, double x, double y) {
    boolean inside = false;
    for (int i = 1; i < outline.size(); i++) {
      Point a = outline.get(i - 1);
      Point b = outline.get(i);
      if (a.y > y != b.y > y && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        inside = !inside;
      }
    }
    return inside;
  }
}
