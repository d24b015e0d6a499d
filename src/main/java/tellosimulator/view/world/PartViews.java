package tellosimulator.view.world;

import javafx.scene.DepthTest;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.FxTextures;

/** Makes nodes of parts that stay as they are. For the JavaFX thread. */
final class PartViews {

  private final FxTextures textures = new FxTextures();

  /** A part. What is painted on something lies at the same depth, so that is not asked. */
  MeshView of(Part part) {
    PhongMaterial material = new PhongMaterial();
    material.setDiffuseMap(textures.image(part.texture()));
    MeshView view = new MeshView(FxMeshes.of(part.mesh()));
    view.setMaterial(material);
    view.setDepthTest(part.finish() == Finish.DECAL ? DepthTest.DISABLE : DepthTest.INHERIT);
    return view;
  }
}
