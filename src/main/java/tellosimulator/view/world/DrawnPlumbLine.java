package tellosimulator.view.world;

import java.util.Optional;
import tellosimulator.math.Attitude;
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

/**
 * The line from a drone straight down to the floor, as the software camera draws it. For the JavaFX
 * thread.
 */
final class DrawnPlumbLine {

  /** How much of what is behind it is hidden. Decided: as in {@link PlumbLine}. */
  private static final double OPACITY = 0.6;

  private final FxDroneModel drone;
  private final Texture color;
  private Size size = new Size(0, 0);
  private Optional<Part> part = Optional.empty();

  private record Size(double width, double height) {}

  DrawnPlumbLine(FxDroneModel drone) {
    this.drone = drone;
    color = new Texture(1, 1, new int[] {drone.livery().color().argb()});
  }

  /**
   * As it is at present; none while the drone is on the floor.
   *
   * @param eye where the camera is, room frame [m]
   */
  Optional<Placed> part(Vec3 eye) {
    Vec3 position = drone.poseProperty().get().position();
    if (position.z() <= PlumbLine.LOWEST) {
      return Optional.empty();
    }
    Size now = new Size(PlumbLine.WIDTH * eye.distanceTo(position), position.z());
    if (part.isEmpty() || !now.equals(size)) {
      size = now;
      part = Optional.of(made(now));
    }
    Pose foot = new Pose(position.withZ(0), Attitude.ofHeading(heading(position, eye)));
    return part.map(line -> new Placed(line, foot, 1, OPACITY));
  }

  private static double heading(Vec3 position, Vec3 eye) {
    return Math.atan2(eye.y() - position.y(), eye.x() - position.x());
  }

  /** A rectangle that one sees from where x leads. */
  private Part made(Size line) {
    Quad quad =
        new Quad(
            new Vec3(0, -line.width / 2, 0),
            new Vec3(0, line.width, 0),
            new Vec3(0, 0, line.height));
    return new Part(new Quads().add(quad, Patch.WHOLE).mesh(), color, Finish.SHEER);
  }
}
