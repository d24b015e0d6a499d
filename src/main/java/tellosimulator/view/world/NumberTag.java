package tellosimulator.view.world;

import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Scale;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.room.Quads;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.drone.DroneColors;

/** A drone's number above it, turned to the camera and equally large from near and far. */
final class NumberTag extends MeshView {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  static final double HEIGHT = 0.07;

  /** Its size, as a part of the distance from the camera. Decided: by eye. */
  static final double SIZE = 0.032;

  private final FxDroneModel drone;
  private final Affine place = new Affine();
  private final Scale size = new Scale();

  NumberTag(FxDroneModel drone) {
    this.drone = drone;
    setId("number-" + drone.number());
    // in a camera's axes: x to the right, y down
    Quad quad = new Quad(new Vec3(-0.5, 0, 0), new Vec3(1, 0, 0), new Vec3(0, -1, 0));
    setMesh(FxMeshes.of(new Quads().add(quad, Patch.WHOLE).mesh()));
    PhongMaterial material = new PhongMaterial();
    material.setDiffuseMap(Pictures.number(drone.number(), DroneColors.of(drone)));
    setMaterial(material);
    setCullFace(CullFace.NONE);
    getTransforms().addAll(place, size);
  }

  /** Goes with the drone and turns to the camera. */
  void advance(Pose camera) {
    Vec3 position = drone.poseProperty().get().position().plusScaled(Vec3.UP, HEIGHT);
    FxFrames.aim(place, new Pose(position, camera.attitude()));
    double scale = SIZE * camera.position().distanceTo(position);
    size.setX(scale);
    size.setY(scale);
  }
}
