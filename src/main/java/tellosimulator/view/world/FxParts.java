package tellosimulator.view.world;

import java.util.Map;
import java.util.WeakHashMap;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.TriangleMesh;
import tellosimulator.scenery.mesh.Material;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.view.fx.FxMeshes;
import tellosimulator.view.fx.FxTextures;

/**
 * Caches meshes and materials of scenes as JavaFX objects. Each is converted once and kept as long
 * as a scene holds the original. Confined to the JavaFX thread.
 */
final class FxParts {

  private final FxTextures textures = new FxTextures();
  private final Map<Mesh, TriangleMesh> meshes = new WeakHashMap<>();
  private final Map<Material, PhongMaterial> materials = new WeakHashMap<>();

  TriangleMesh mesh(Mesh mesh) {
    return meshes.computeIfAbsent(mesh, FxMeshes::of);
  }

  /** Returns the converted material that all instances share. */
  PhongMaterial shared(Material material) {
    return materials.computeIfAbsent(material, this::converted);
  }

  /** Returns a new converted material that is not shared. */
  PhongMaterial converted(Material material) {
    PhongMaterial converted = new PhongMaterial();
    converted.setDiffuseMap(textures.image(material.texture()));
    if (material.shading() == Shading.GLOSSY) {
      converted.setSpecularColor(Color.gray(0.35));
      converted.setSpecularPower(28);
    }
    return converted;
  }
}
