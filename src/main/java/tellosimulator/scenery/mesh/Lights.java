package tellosimulator.scenery.mesh;

import java.util.List;
import tellosimulator.math.Vec3;

/**
 * The lights in the room. A surface is as bright as the sum of all of them, at most white.
 *
 * @param ambient light from all sides
 * @param directional parallel lights
 */
public record Lights(Rgb ambient, List<Directional> directional) {

  /**
   * Parallel light.
   *
   * @param color what it adds to a surface that faces it
   * @param direction in which it shines, a unit vector of the room frame
   */
  public record Directional(Rgb color, Vec3 direction) {}

  /** The direction in which the key light shines: from the left, as through windows. */
  public static final Vec3 KEY = new Vec3(0.45, -0.35, -0.82).normalized();

  private static final Vec3 FILL = new Vec3(-0.7, 0.5, 0.1).normalized();

  /** A key light from above, and a fill light so that no side is flat. Decided: by eye. */
  public static final Lights ON_DRONES =
      new Lights(
          Rgb.of(0x86878c),
          List.of(new Directional(Rgb.of(0x8f8b84), KEY), new Directional(Rgb.of(0x2c3038), FILL)));

  /**
   * The same lights, brighter on the sides, so that a thing has nearly the colour that was chosen
   * for it. Decided: by eye; a top is as bright as its paint, the darkest side has seven tenths of
   * that.
   */
  public static final Lights ON_FURNITURE =
      new Lights(
          Rgb.of(0xb3b3b4),
          List.of(new Directional(Rgb.of(0x5c5b58), KEY), new Directional(Rgb.of(0x232427), FILL)));

  /** Where the key light that comes by a point above the floor falls on it, room frame [m]. */
  public static Vec3 onFloor(Vec3 point) {
    return point.plusScaled(KEY, -point.z() / KEY.z());
  }

  public Lights {
    directional = List.copyOf(directional);
  }
}
