package tellosimulator.scenery;

import java.util.List;
import tellosimulator.math.Vec3;

/** The light in the room. A part's brightness is the sum of all lights, at most white. */
public final class Lamps {

  /** Light from all sides. Decided: by eye. */
  public static final Rgb AMBIENT = Rgb.of(0x86878c);

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

  /**
   * A lamp above, and weaker light from the other side so that no side is flat. Decided: by eye.
   */
  public static final List<Lamp> ALL =
      List.of(
          new Lamp(Rgb.of(0x8f8b84), new Vec3(0.45, -0.35, -0.82).normalized()),
          new Lamp(Rgb.of(0x2c3038), new Vec3(-0.7, 0.5, 0.1).normalized()));

  private Lamps() {}
}
