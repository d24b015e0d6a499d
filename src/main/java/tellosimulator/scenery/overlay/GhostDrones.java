package tellosimulator.scenery.overlay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Material;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/**
 * Makes ghosts of drones: translucent, and tinted with one colour, as aids for people. Keeps the
 * parts that it has made. For one thread.
 */
public final class GhostDrones {

  /** Decided: by eye; what is behind can be seen through it. */
  private static final double OPACITY = 0.55;

  /** How far each colour of a drone goes to that of the ghost. Decided: its parts still differ. */
  private static final double TINT = 0.6;

  private final Rgb color;
  private final Map<Part, Part> ghosts = new HashMap<>();
  private final Map<Material, Material> materials = new HashMap<>();

  /** Ghosts of one colour. */
  public GhostDrones(Rgb color) {
    this.color = color;
  }

  /**
   * The ghosts of drones.
   *
   * @param drones their bodies, lamps and propellers, as a scene has them
   */
  public List<Instance> of(List<Instance> drones) {
    return drones.stream()
        .map(one -> new Instance(ghost(one.part()), one.pose(), one.scale(), one.opacity()))
        .toList();
  }

  private Part ghost(Part part) {
    return ghosts.computeIfAbsent(
        part,
        original ->
            new Part(original.mesh(), materials.computeIfAbsent(original.material(), this::ghost)));
  }

  private Material ghost(Material material) {
    Texture original = material.texture();
    int[] texels = original.argbArray();
    for (int i = 0; i < texels.length; i++) {
      double alpha = (texels[i] >>> 24) / 255.0;
      texels[i] = Rgb.of(texels[i]).towards(color, TINT).argb(OPACITY * alpha);
    }
    return new Material(
        new Texture(original.width(), original.height(), texels), Shading.TRANSLUCENT);
  }
}
