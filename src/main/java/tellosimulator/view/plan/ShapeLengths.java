package tellosimulator.view.plan;

import java.util.List;
import java.util.function.DoubleFunction;
import tellosimulator.scenario.Quantity;
import tellosimulator.world.Shape;

/**
 * The editable lengths of a shape. Immutable.
 *
 * @param kind the suffix of the message key for the list of lengths
 */
record ShapeLengths(String kind, List<Length> lengths) {

  /**
   * A length of a shape.
   *
   * @param key the key of the length's property
   * @param with returns the shape with another length [m]; a gate that would reach below the floor
   *     is raised
   */
  record Length(String key, Quantity quantity, double meters, DoubleFunction<Shape> with) {}

  private ShapeLengths(String kind, Length... lengths) {
    this(kind, List.of(lengths));
  }

  static ShapeLengths of(Shape shape) {
    return shape.match(
        new Shape.Cases<>(
            box ->
                new ShapeLengths(
                    "box",
                    size("depth", box.depth(), to -> new Shape.Box(to, box.width(), box.height())),
                    size("width", box.width(), to -> new Shape.Box(box.depth(), to, box.height())),
                    size(
                        "height", box.height(), to -> new Shape.Box(box.depth(), box.width(), to))),
            cylinder ->
                new ShapeLengths(
                    "cylinder",
                    diameter(cylinder.radius(), to -> new Shape.Cylinder(to, cylinder.height())),
                    size(
                        "height",
                        cylinder.height(),
                        to -> new Shape.Cylinder(cylinder.radius(), to))),
            ring ->
                new ShapeLengths(
                    "ring",
                    diameter(
                        ring.radius(),
                        to ->
                            new Shape.Ring(
                                to, ring.tube(), Math.max(to + ring.tube(), ring.middle()))),
                    size(
                        "middle",
                        ring.middle(),
                        to ->
                            new Shape.Ring(
                                ring.radius(),
                                ring.tube(),
                                Math.max(ring.radius() + ring.tube(), to)))),
            frame ->
                new ShapeLengths(
                    "frame",
                    size("width", frame.width(), to -> frame(to, frame.opening(), frame)),
                    size("opening", frame.opening(), to -> frame(frame.width(), to, frame)),
                    size(
                        "middle",
                        frame.middle(),
                        to ->
                            new Shape.Frame(
                                frame.width(),
                                frame.opening(),
                                frame.beam(),
                                Math.max(frame.opening() / 2, to))))));
  }

  private static Shape frame(double width, double opening, Shape.Frame like) {
    return new Shape.Frame(width, opening, like.beam(), Math.max(opening / 2, like.middle()));
  }

  private static Length size(String key, double meters, DoubleFunction<Shape> with) {
    return new Length(key, Quantity.SIZE, meters, with);
  }

  private static Length diameter(double radius, DoubleFunction<Shape> with) {
    return new Length("diameter", Quantity.DIAMETER, 2 * radius, to -> with.apply(to / 2));
  }
}
