package tellosimulator.view.world;

import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Scale;
import javafx.scene.transform.Translate;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.world.Quads.Quad;

/**
 * What a drone leaves on the floor: its shadow, and the mark where it starts. Drawn right after the
 * floor and without the test for depth, so that nothing flickers.
 */
final class GroundMarks extends Group {

  /** Edge of the start mark [m]. Decided: the drone covers the ring only in part. */
  private static final double START_SIZE = 0.42;

  private final FxDroneModel drone;
  private final MeshView start = new MeshView();
  private final MeshView shadow = new MeshView();
  private final Affine startPlace = new Affine();
  private final Translate shadowPlace = new Translate();
  private final Scale shadowSize = new Scale();
  private final PhongMaterial shadowMaterial = new PhongMaterial();
  private double shownOpacity = -1;

  GroundMarks(FxDroneModel drone) {
    this.drone = drone;
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
  }

  private void initializeSelf() {
    setDepthTest(DepthTest.DISABLE);
  }

  private void initializeParts() {
    PhongMaterial startMaterial = new PhongMaterial();
    startMaterial.setDiffuseMap(Pictures.startMark());
    startMaterial.setDiffuseColor(DroneColors.of(drone.number()).deriveColor(0, 0.85, 1, 0.8));
    start.setId("start-" + drone.number());
    start.setMesh(new Quads().add(Quad.onFloor(START_SIZE), Quads.WHOLE).mesh());
    start.setMaterial(startMaterial);
    start.getTransforms().add(startPlace);
    shadowMaterial.setDiffuseMap(Pictures.shadow());
    shadow.setId("shadow-" + drone.number());
    shadow.setMesh(new Quads().add(Quad.onFloor(2), Quads.WHOLE).mesh());
    shadow.setMaterial(shadowMaterial);
    shadow.getTransforms().addAll(shadowPlace, shadowSize);
  }

  private void layoutParts() {
    getChildren().addAll(start, shadow);
  }

  private void setupBindings() {
    drone.startProperty().subscribe(pose -> FxFrames.place(startPlace, onFloor(pose)));
    drone.poseProperty().subscribe(this::castShadow);
  }

  private void castShadow(Pose pose) {
    Vec3 position = pose.position();
    Shadow cast = Shadow.at(position.z());
    shadowPlace.setX(position.x());
    shadowPlace.setY(position.y());
    shadowSize.setX(cast.radius());
    shadowSize.setY(cast.radius());
    if (Math.abs(cast.opacity() - shownOpacity) > 0.004) {
      shownOpacity = cast.opacity();
      shadowMaterial.setDiffuseColor(Color.gray(1, shownOpacity));
    }
  }

  private static Pose onFloor(Pose pose) {
    return new Pose(pose.position().withZ(0), pose.attitude());
  }
}
