package tellosimulator.scenery.texture;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * A square coverage mask on which strokes and polygons are drawn with antialiasing. The coverage of
 * a pixel depends on the distance of its centre from the edge of the shape. Coordinates are in
 * pixels, measured from the left and from the top. Not thread-safe.
 */
public final class AlphaMask {

  /** A point, in pixels from the left and from the top. */
  public record Point(double x, double y) {

    /**
     * Returns the points of a polyline.
     *
     * @param numbers x and y of each point
     */
    public static List<Point> polyline(double... numbers) {
      List<Point> points = new ArrayList<>();
      for (int i = 0; i < numbers.length; i += 2) {
        points.add(new Point(numbers[i], numbers[i + 1]));
      }
      return points;
    }
  }

  /** An arc of an ellipse; angles in radians, clockwise from the positive x axis. */
  public record Arc(Point center, Point radii, double from, double to) {

    /**
     * Number of segments in a whole turn. Decided: no corners are visible at a size of 256 pixels.
     */
    private static final int SEGMENTS_PER_TURN = 48;

    /** Returns a full circle. */
    public static Arc circle(Point center, double radius) {
      return new Arc(center, new Point(radius, radius), 0, 2 * Math.PI);
    }

    /** Returns points along the arc, from one end to the other. */
    public List<Point> points() {
      int parts = (int) Math.ceil(Math.abs(to - from) / (2 * Math.PI) * SEGMENTS_PER_TURN);
      List<Point> points = new ArrayList<>();
      for (int i = 0; i <= parts; i++) {
        double angle = from + (to - from) * i / parts;
        points.add(
            new Point(
                center.x + radii.x * StrictMath.cos(angle),
                center.y + radii.y * StrictMath.sin(angle)));
      }
      return points;
    }
  }

  private final int size;
  private final double[] coverage;

  /**
   * Creates an empty mask.
   *
   * @param size side length of the mask [pixels]
   */
  public AlphaMask(int size) {
    this.size = size;
    coverage = new double[size * size];
  }

  /**
   * Draws a stroke with round ends.
   *
   * @param polyline centre line of the stroke
   * @param width width of the stroke [pixels]
   */
  public AlphaMask stroke(List<Point> polyline, double width) {
    for (int i = 1; i < polyline.size(); i++) { // segment by segment: each covers only a few pixels
      stroke(polyline.get(i - 1), polyline.get(i), width / 2);
    }
    return this;
  }

  /** Draws a filled polygon. */
  public AlphaMask fill(List<Point> corners) {
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
        cover(x, y, inside(outline, x + 0.5, y + 0.5) ? edge : -edge);
      }
    }
    return this;
  }

  /**
   * Returns a texture of one colour whose alpha is a mask. The mask is drawn on first use.
   *
   * @param size side length of the texture [texels]
   * @param mask creates a mask of this size
   */
  public static Texture texture(int size, Rgb color, Supplier<AlphaMask> mask) {
    return Texture.lazy(size, size, () -> mask.get().argb(color));
  }

  /** Returns texels of one colour, with this mask as their alpha. */
  private int[] argb(Rgb color) {
    int[] argb = new int[coverage.length];
    for (int i = 0; i < argb.length; i++) {
      argb[i] = color.argb(coverage[i]);
    }
    return argb;
  }

  /** Paints a colour over an opaque image of the same size, where this mask covers it. */
  void paint(Rgb color, int[] pixels) {
    for (int i = 0; i < pixels.length; i++) {
      if (coverage[i] > 0) {
        pixels[i] = Rgb.of(pixels[i]).towards(color, coverage[i]).argb();
      }
    }
  }

  /** Returns a copy of an image of the same size, with this mask as its alpha. */
  int[] applyTo(int[] pixels) {
    int[] argb = new int[pixels.length];
    for (int i = 0; i < argb.length; i++) {
      argb[i] = Rgb.of(pixels[i]).argb(coverage[i]);
    }
    return argb;
  }

  /** Draws a filled circle. */
  public AlphaMask dot(Point center, double radius) {
    return stroke(List.of(center, center), 2 * radius);
  }

  private void stroke(Point from, Point to, double radius) {
    int bottom = last(Math.max(from.y, to.y) + radius);
    int left = first(Math.min(from.x, to.x) - radius);
    int right = last(Math.max(from.x, to.x) + radius);
    for (int y = first(Math.min(from.y, to.y) - radius); y <= bottom; y++) {
      for (int x = left; x <= right; x++) {
        cover(x, y, radius - distance(from, to, x + 0.5, y + 0.5));
      }
    }
  }

  /**
   * Raises the coverage of a pixel.
   *
   * @param within distance of the pixel's centre from the edge of the shape, positive inside
   *     [pixels]
   */
  private void cover(int x, int y, double within) {
    double covered = Math.max(0, Math.min(1, within + 0.5));
    coverage[y * size + x] = Math.max(coverage[y * size + x], covered);
  }

  /** Returns the first pixel that the edge of a shape may touch. */
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

  /** Returns whether a ray to the right crosses the outline an odd number of times. */
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
