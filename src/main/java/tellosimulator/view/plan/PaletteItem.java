package tellosimulator.view.plan;

import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/** The obstacles of the palette, each in a handy size that fits into a room. */
enum PaletteItem {
  BOX(0xd9772b, Pattern.PLAIN, room -> new Shape.Box(0.6, 0.6, Math.min(0.6, room.height()))),
  WALL(0xb5654a, Pattern.BRICKS, room -> new Shape.Box(0.1, 1.5, Math.min(1.5, room.height()))),
  CYLINDER(0x2f7fb5, Pattern.PLAIN, room -> new Shape.Cylinder(0.2, Math.min(1, room.height()))),
  RING(0xc8374a, Pattern.STRIPES, room -> ring(room.height())),
  FRAME(0x3a9a5b, Pattern.STRIPES, room -> frame(room.height()));

  private static final double GATE_MIDDLE = 1;

  private final ObstacleAppearance appearance;
  private final Function<Room, Shape> shape;

  PaletteItem(int rgb, Pattern pattern, Function<Room, Shape> shape) {
    this.appearance = new ObstacleAppearance(rgb, pattern, Map.of());
    this.shape = shape;
  }

  Shape shape(Room room) {
    return shape.apply(room);
  }

  ObstacleAppearance appearance() {
    return appearance;
  }

  /** The word with which names begin, and the end of the keys of its texts. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  private static Shape ring(double ceiling) {
    double radius = Math.min(0.4, ceiling / 2 - 0.2);
    return new Shape.Ring(radius, 0.05, middle(ceiling, radius + 0.05));
  }

  private static Shape frame(double ceiling) {
    double opening = Math.min(0.8, ceiling - 0.4);
    return new Shape.Frame(0.8, opening, 0.05, middle(ceiling, opening / 2 + 0.05));
  }

  private static double middle(double ceiling, double half) {
    return Math.max(half, Math.min(GATE_MIDDLE, ceiling - half));
  }
}
