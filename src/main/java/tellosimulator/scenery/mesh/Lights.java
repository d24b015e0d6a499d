package tellosimulator.scenery.mesh;

import java.util.List;
import tellosimulator.math.Vec3;

/**
 * The lights in the room. The brightness of a surface is the sum of all lights, clamped at white.
 *
 * @param ambient light from all directions
 * @param directional parallel lights
 */
public record Lights(Rgb ambient, List<Directional> directional) {

  /**
   * A light with parallel rays.
   *
   * @param color light that is added to a surface facing the light
   * @param direction direction in which the light shines, a unit vector in the room frame
   */
  public record Directional(Rgb color, Vec3 direction) {}

  /** The direction in which the key light shines: from the left, as through windows. */
  public static final Vec3 KEY = new Vec3(0.45, -0.35, -0.82).normalized();

  private static final Vec3 FILL = new Vec3(-0.7, 0.5, 0.1).normalized();

  /**
   * The lights on drones: a key light from above, and a fill light so that no side looks flat.
   * Decided: by eye.
   */
  public static final Lights ON_DRONES =
      new Lights(
          Rgb.of(0x86878c),
          List.of(new Directional(Rgb.of(0x8f8b84), KEY), new Directional(Rgb.of(0x2c3038), FILL)));

  /**
   * The lights on furniture. They have the directions of {@link #ON_DRONES}, but brighten the sides
   * of objects more, so that furniture appears nearly in its configured colour. Decided: by eye;
   * the top of an object is as bright as its paint, and its darkest side has 70 % of that
   * brightness.
   */
  public static final Lights ON_FURNITURE =
      new Lights(
          Rgb.of(0xb3b3b4),
          List.of(new Directional(Rgb.of(0x5c5b58), KEY), new Directional(Rgb.of(0x232427), FILL)));

  /**
   * Projects a point above the floor onto the floor, along the key light. Both points are in the
   * room frame [m].
   */
  public static Vec3 onFloor(Vec3 point) {
    return point.plusScaled(KEY, -point.z() / KEY.z());
  }

  public Lights {
    directional = List.copyOf(directional);
  }
}
