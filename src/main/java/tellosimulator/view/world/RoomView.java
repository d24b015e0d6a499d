package tellosimulator.view.world;

import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.room.Interior;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.FxTextures;

/** The room with all that is painted on it. Made anew when the room or its decor changes. */
final class RoomView extends Group {

  private final FxSimulation simulation;
  private final Interior interior = new Interior();
  private final FxTextures textures = new FxTextures();

  RoomView(FxSimulation simulation) {
    this.simulation = simulation;
    setId("room");
    simulation.decorProperty().subscribe(decor -> build());
    simulation.roomProperty().addListener((property, before, room) -> build());
  }

  private void build() {
    getChildren()
        .setAll(
            interior
                .parts(simulation.roomProperty().get(), simulation.decorProperty().get())
                .stream()
                .map(this::view)
                .toList());
  }

  /** A part of the room. What is painted on it lies at the same depth, so that is not asked. */
  private MeshView view(Part part) {
    PhongMaterial material = new PhongMaterial();
    material.setDiffuseMap(textures.image(part.texture()));
    MeshView view = new MeshView(FxMeshes.of(part.mesh()));
    view.setMaterial(material);
    view.setDepthTest(part.finish() == Finish.DECAL ? DepthTest.DISABLE : DepthTest.INHERIT);
    return view;
  }
}
