package tellosimulator.scenery;

import java.util.List;
import tellosimulator.math.Vec3;

/**
 * The light in the room. A part's brightness is the sum of all lights, at most white.
 *
 * @param ambient light from all sides
 * @param all parallel lights
 */
public record Lamps(Rgb ambient, List<Lamp> all) {

  /**
   * Parallel light.
   *
   * @param color how bright what faces it becomes
   * @param direction in which it shines, room frame, of length 1
   */
  public record Lamp(Rgb color, Vec3 direction) {

    /** How bright a surface with this unit normal in the room frame is in its light, 0 to 1. */
    public double falling(Vec3 normal) {
      return Math.max(0, -direction.dot(normal));
    }
  }

  private static final Vec3 FROM_ABOVE = new Vec3(0.45, -0.35, -0.82).normalized();

  private static final Vec3 FROM_THE_OTHER_SIDE = new Vec3(-0.7, 0.5, 0.1).normalized();

  /**
   * On drones: a lamp above, and weaker light from the other side so that no side is flat. Decided:
   * by eye.
   */
  public static final Lamps ON_DRONES =
      new Lamps(
          Rgb.of(0x86878c),
          List.of(
              new Lamp(Rgb.of(0x8f8b84), FROM_ABOVE),
              new Lamp(Rgb.of(0x2c3038), FROM_THE_OTHER_SIDE)));

  /**
   * On what stands in the room: the same lamps, but brighter on the sides, so that a thing has
   * nearly the colour that was chosen for it. Decided: by eye; a top is as bright as its paint, the
   * darkest side has seven tenths of that.
   */
  public static final Lamps ON_FURNITURE =
      new Lamps(
          Rgb.of(0xb3b3b4),
          List.of(
              new Lamp(Rgb.of(0x5c5b58), FROM_ABOVE),
              new Lamp(Rgb.of(0x232427), FROM_THE_OTHER_SIDE)));

  public Lamps {
    all = List.copyOf(all);
  }
}
