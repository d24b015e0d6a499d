package tellosimulator.view.world;

import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Scale;
import javafx.scene.transform.Translate;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.room.Quads;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxMeshes;
import tellosimulator.view.drone.DroneColors;

/** The line from a drone straight down to the floor. */
final class PlumbLine extends MeshView {

  /** Below this height there is none [m]. Decided. */
  static final double LOWEST = 0.03;

  /** Its width, as a part of the distance from the camera. Decided: two or three pixels. */
  static final double WIDTH = 0.0025;

  private final FxDroneModel drone;
  private final Translate foot = new Translate();
  private final Scale size = new Scale();

  PlumbLine(FxDroneModel drone) {
    this.drone = drone;
    setId("plumb-line-" + drone.number());
    setMesh(
        FxMeshes.of(
            new Quads()
                .add(new Quad(new Vec3(-0.5, 0, 0), new Vec3(1, 0, 0), Vec3.UP), Patch.WHOLE)
                .add(new Quad(new Vec3(0, -0.5, 0), new Vec3(0, 1, 0), Vec3.UP), Patch.WHOLE)
                .mesh()));
    setMaterial(new PhongMaterial(DroneColors.of(drone).deriveColor(0, 1, 1, 0.6)));
    setCullFace(CullFace.NONE);
    getTransforms().addAll(foot, size);
  }

  /**
   * Goes with the drone.
   *
   * @param eye where the camera is, room frame [m]
   */
  void advance(Vec3 eye) {
    Vec3 position = drone.poseProperty().get().position();
    setVisible(position.z() > LOWEST);
    if (isVisible()) {
      double width = WIDTH * eye.distanceTo(position);
      foot.setX(position.x());
      foot.setY(position.y());
      size.setX(width);
      size.setY(width);
      size.setZ(position.z());
    }
  }
}
