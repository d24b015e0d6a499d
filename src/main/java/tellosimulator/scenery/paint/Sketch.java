package tellosimulator.scenery.paint;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;

/**
 * A drawing in one ink on nothing. Places are in pixels, from the left and from the top. Its edges
 * are smooth: how much ink a pixel gets hangs on the distance of its middle from the edge. For one
 * thread.
 */
public final class Sketch {

  /** A place: pixels from the left and from the top. */
  public record Point(double x, double y) {

    private double distanceTo(double px, double py) {
      return Math.sqrt((px - x) * (px - x) + (py - y) * (py - y));
    }
  }

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
            new Point(middle.x + radii.x * Math.cos(angle), middle.y + radii.y * Math.sin(angle)));
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
      Point from = way.get(i - 1);
      Point to = way.get(i);
      soak(List.of(from, to), width / 2, pixel -> width / 2 - distance(from, to, pixel));
    }
    return this;
  }

  /** A surface between straight edges, the last of which leads back to the first corner. */
  public Sketch fill(List<Point> corners) {
    List<Point> outline = new ArrayList<>(corners);
    outline.add(corners.get(0));
    soak(
        outline,
        0,
        pixel -> inside(outline, pixel) ? distance(outline, pixel) : -distance(outline, pixel));
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

  /**
   * Gives ink to all pixels around some points.
   *
   * @param reach how far around them [pixels]
   * @param within how far a pixel lies within the edge [pixels]
   */
  private void soak(List<Point> around, double reach, ToDoubleFunction<Point> within) {
    DoubleSummaryStatistics across = around.stream().mapToDouble(Point::x).summaryStatistics();
    DoubleSummaryStatistics down = around.stream().mapToDouble(Point::y).summaryStatistics();
    for (int y = first(down, reach); y <= last(down, reach); y++) {
      for (int x = first(across, reach); x <= last(across, reach); x++) {
        double edge = within.applyAsDouble(new Point(x + 0.5, y + 0.5));
        double wet = Math.max(0, Math.min(1, edge + 0.5));
        ink[y * size + x] = Math.max(ink[y * size + x], wet);
      }
    }
  }

  private static int first(DoubleSummaryStatistics extent, double reach) {
    return (int) Math.max(0, Math.floor(extent.getMin() - reach) - 1);
  }

  private int last(DoubleSummaryStatistics extent, double reach) {
    return (int) Math.min(size - 1, Math.ceil(extent.getMax() + reach) + 1);
  }

  private static double distance(List<Point> way, Point pixel) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 1; i < way.size(); i++) {
      nearest = Math.min(nearest, distance(way.get(i - 1), way.get(i), pixel));
    }
    return nearest;
  }

  private static double distance(Point from, Point to, Point pixel) {
    double dx = to.x - from.x;
    double dy = to.y - from.y;
    double squared = dx * dx + dy * dy;
    double along = squared == 0 ? 0 : ((pixel.x - from.x) * dx + (pixel.y - from.y) * dy) / squared;
    double within = Math.max(0, Math.min(1, along));
    return pixel.distanceTo(from.x + dx * within, from.y + dy * within);
  }

  /** Whether a ray to the right crosses the outline an odd number of times. */
  private static boolean inside(List<Point> outline, Point pixel) {
    boolean inside = false;
    for (int i = 1; i < outline.size(); i++) {
      Point a = outline.get(i - 1);
      Point b = outline.get(i);
      if (a.y > pixel.y != b.y > pixel.y
          && pixel.x < a.x + (pixel.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        inside = !inside;
      }
    }
    return inside;
  }
}
