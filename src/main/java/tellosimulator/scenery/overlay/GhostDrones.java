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
 * Creates ghosts of drones: translucent drones, tinted with one colour, as visual aids for people.
 * Caches the parts. Not thread-safe.
 */
public final class GhostDrones {

  /** Opacity of a ghost. Decided: by eye; objects behind the ghost stay visible. */
  private static final double OPACITY = 0.55;

  /**
   * Weight of the ghost's colour when it is mixed with the colours of a drone. Decided: the parts
   * of the drone are still distinguishable.
   */
  private static final double TINT = 0.6;

  private final Rgb color;
  private final Map<Part, Part> ghosts = new HashMap<>();
  private final Map<Material, Material> materials = new HashMap<>();

  /** Creates a source of ghosts of one colour. */
  public GhostDrones(Rgb color) {
    this.color = color;
  }

  /**
   * Returns the ghosts of drones.
   *
   * @param drones bodies, lamps and propellers of the drones, as in a scene
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
