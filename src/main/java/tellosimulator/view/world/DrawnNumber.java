package tellosimulator.view.world;

import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.Quads;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.drone.DroneColors;

/**
 * A drone's number above it, turned to the camera and equally large from near and far, as the
 * software camera draws it. For the JavaFX thread.
 */
final class DrawnNumber {

  private final FxDroneModel drone;
  private final Part part;

  DrawnNumber(FxDroneModel drone) {
    this.drone = drone;
    // in a camera's frame, seen from behind: to the right and up
    Quad quad = new Quad(new Vec3(0, 0.5, -0.5), new Vec3(0, -1, 0), new Vec3(0, 0, 1));
    part =
        new Part(
            new Quads().add(quad, Patch.WHOLE).mesh(),
            texture(Pictures.number(drone.number(), DroneColors.of(drone))),
            Finish.SHEER);
  }

  /** As it is at present. */
  Placed part(Pose camera) {
    Vec3 position = drone.poseProperty().get().position().plusScaled(Vec3.UP, NumberTag.HEIGHT);
    double scale = NumberTag.SIZE * camera.position().distanceTo(position);
    return new Placed(part, new Pose(position, camera.attitude()), scale, 1);
  }

  private static Texture texture(Image image) {
    int width = (int) image.getWidth();
    int height = (int) image.getHeight();
    int[] argb = new int[width * height];
    image
        .getPixelReader()
        .getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
    return new Texture(width, height, argb);
  }
}
