package tellosimulator.scenery.drone;

import java.util.EnumMap;
import java.util.Map;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;

/**
 * The glow around a lit lamp. Only people see it; drones' cameras do not. The glow is necessary
 * because, seen from two metres away, the lamp itself is smaller than a pixel. The glow consists of
 * two crossed squares, one upright and one level. All positions are in the body frame [m].
 */
final class LampGlow {

  /**
   * Half the side length of the squares [m]. Decided: by eye; about half the length of the drone.
   */
  private static final double RADIUS = 0.045;

  private static final double OPACITY = 0.85;

  private static final int SIZE = 32;

  private LampGlow() {}

  static Map<StatusLight, Part> parts() {
    Mesh squares = squares();
    Map<StatusLight, Part> parts = new EnumMap<>(StatusLight.class);
    for (StatusLight light : StatusLight.values()) {
      parts.put(light, new Part(squares, texture(light.color()), Shading.TRANSLUCENT));
    }
    return parts;
  }

  private static Mesh squares() {
    MeshBuilder mesh = new MeshBuilder();
    Vec3 across = new Vec3(0, 2 * RADIUS, 0);
    for (Vec3 up : new Vec3[] {new Vec3(0, 0, 2 * RADIUS), new Vec3(-2 * RADIUS, 0, 0)}) {
      Vec3 corner =
          StatusLamp.PLACE
              .plus(new Vec3(StatusLamp.RADIUS, 0, 0))
              .minus(across.times(0.5))
              .minus(up.times(0.5));
      mesh.quad(new Quad(corner, across, up), TextureRegion.WHOLE);
      mesh.quad(new Quad(corner, up, across), TextureRegion.WHOLE); // the back
    }
    return mesh.build();
  }

  /** Returns a texture that is bright in the middle and transparent at the edges. */
  private static Texture texture(Rgb color) {
    return ProceduralTexture.radial(
        SIZE, near -> color.towards(Rgb.WHITE, near * near * near).argb(OPACITY * near * near));
  }
}
