package tellosimulator.view.world;

import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Scale;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.room.GroundMark;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.FxTextures;

/**
 * What a drone leaves on the floor: its shadow, and the mark where it starts. Drawn right after the
 * floor and without the test for depth, so that nothing flickers.
 */
final class GroundMarks extends Group {

  /** A mark in the scene. */
  private static final class Mark extends MeshView {

    private final Affine place = new Affine();
    private final Scale size = new Scale();
    private final PhongMaterial material = new PhongMaterial();
    private double opacity = -1;

    private Mark(String id) {
      setId(id);
      setMaterial(material);
      getTransforms().addAll(place, size);
    }

    private void show(Placed mark, FxTextures textures) {
      if (getMesh() == null) {
        setMesh(FxMeshes.of(mark.part().mesh()));
        material.setDiffuseMap(textures.image(mark.part().texture()));
      }
      FxFrames.place(place, mark.pose());
      size.setX(mark.scale());
      size.setY(mark.scale());
      if (Math.abs(mark.opacity() - opacity) > 0.004) {
        opacity = mark.opacity();
        material.setDiffuseColor(Color.gray(1, opacity));
      }
    }
  }

  GroundMarks(FxDroneModel drone) {
    GroundMark mark = new GroundMark(drone.livery());
    FxTextures textures = new FxTextures();
    Mark start = new Mark("start-" + drone.number());
    Mark shadow = new Mark("shadow-" + drone.number());
    setDepthTest(DepthTest.DISABLE);
    getChildren().addAll(start, shadow);
    drone.startProperty().subscribe(pose -> start.show(mark.start(pose), textures));
    drone.poseProperty().subscribe(pose -> shadow.show(mark.shadow(pose), textures));
  }
}
