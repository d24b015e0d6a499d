package tellosimulator.view.world;

import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Scale;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.room.GroundMark;
import tellosimulator.scenery.room.Underneath;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.FxTextures;

/**
 * What a drone leaves on the floor: its shadow, and the mark where it starts. Drawn right after the
 * floor and without the test for depth, so that nothing flickers. On an obstacle, the shadow is a
 * node of its own.
 */
final class GroundMarks extends Group {

  /** So far above an obstacle its shadow does not flicker [m]. Decided: from 10 m away. */
  private static final double RAISED = 0.002;

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

  private final Mark onObstacle;

  GroundMarks(FxDroneModel drone, FxSimulation simulation, Underneath underneath) {
    GroundMark mark = new GroundMark(drone.livery());
    FxTextures textures = new FxTextures();
    Mark start = new Mark("start-" + drone.number());
    Mark shadow = new Mark("shadow-" + drone.number());
    onObstacle = new Mark("raised-shadow-" + drone.number());
    onObstacle.setTranslateZ(RAISED);
    setDepthTest(DepthTest.DISABLE);
    getChildren().addAll(start, shadow);
    drone.startProperty().subscribe(pose -> start.show(mark.start(pose), textures));
    Runnable cast =
        () -> {
          Vec3 position = drone.poseProperty().get().position();
          Placed placed = GroundMark.shadow(underneath, simulation.arenaProperty().get(), position);
          boolean onFloor = placed.pose().position().z() == 0;
          shadow.setVisible(onFloor);
          onObstacle.setVisible(!onFloor);
          (onFloor ? shadow : onObstacle).show(placed, textures);
        };
    drone.poseProperty().subscribe(pose -> cast.run());
    simulation.arenaProperty().addListener((property, before, arena) -> cast.run());
  }

  /** The shadow while it falls on an obstacle; to be drawn after these. */
  Node onObstacle() {
    return onObstacle;
  }
}
