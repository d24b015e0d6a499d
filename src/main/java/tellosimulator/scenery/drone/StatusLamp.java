package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Loft.Section;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/** The lamp beside the lens, in all its colours. All positions are in the body frame [m]. */
final class StatusLamp {

  /** Centre of the lamp. Assumed: by eye, from pictures. */
  static final Vec3 PLACE = new Vec3(0.0488, 0.0088, 0.0205);

  /** Radius of the lamp. Assumed: by eye, from pictures. */
  static final double RADIUS = 0.0021;

  private static final int SIDES = 8;

  private StatusLamp() {}

  static Map<StatusLight, Part> parts() {
    Mesh ball = ball(PLACE, RADIUS);
    Map<StatusLight, Part> parts = new EnumMap<>(StatusLight.class);
    for (StatusLight light : StatusLight.values()) {
      int[] pixels = new int[4];
      Arrays.fill(pixels, light.color().argb());
      parts.put(light, new Part(ball, new Texture(2, 2, pixels), Shading.UNLIT));
    }
    return parts;
  }

  /** Creates a ball in the body frame [m]. */
  static Mesh ball(Vec3 middle, double radius) {
    List<Section> sections = new ArrayList<>();
    for (int i = 0; i < SIDES / 2; i++) {
      double angle = Math.PI * (2 * i + 1) / SIDES;
      Vec3 center = middle.minus(new Vec3(radius * StrictMath.cos(angle), 0, 0));
      sections.add(new Section(center, radius * StrictMath.sin(angle)));
    }
    SmoothMeshBuilder mesh = new SmoothMeshBuilder();
    Loft.tube(mesh, sections, SIDES);
    return mesh.build();
  }
}
