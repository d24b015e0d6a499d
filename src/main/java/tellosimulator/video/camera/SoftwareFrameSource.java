package tellosimulator.video.camera;

import java.util.Arrays;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.scenery.Scene;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** Films with a software camera. For one thread at a time. */
public final class SoftwareFrameSource implements FrameSource {

  /** Makes the scene of a moment. */
  @FunctionalInterface
  public interface Setting {

    /** What the cameras on a drone see: all but the drone itself. */
    Scene scene(SimSnapshot snapshot, int drone);
  }

  /** All that a picture depends on, besides its size and the optics. */
  record Sight(Scene scene, Pose drone, boolean downward) {}

  /** No colour. */
  private static final byte NEUTRAL = (byte) 128;

  private final SoftwareCamera camera;
  private final DroneOptics optics;
  private final Setting setting;
  private Optional<Raster> raster = Optional.empty();

  /**
   * @param props for {@link ColorSpace#YUV}; those of all sources, as they take much memory
   */
  public SoftwareFrameSource(Props props, DroneOptics optics, Setting setting) {
    if (props.space() != ColorSpace.YUV) {
      throw new IllegalArgumentException("props is for " + props.space() + ", but must be for YUV");
    }
    camera = new SoftwareCamera(props);
    this.optics = optics;
    this.setting = setting;
  }

  @Override
  public void film(SimSnapshot snapshot, Shot shot, Picture picture) {
    Sight sight = sight(snapshot, shot);
    if (shot.downward()) {
      filmBelow(sight.scene, sight.drone, picture);
    } else {
      Viewpoint ahead = optics.ahead(sight.drone, picture.width(), picture.height());
      camera.draw(sight.scene, ahead, raster(picture, picture.height()));
    }
  }

  @Override
  public Sight sight(SimSnapshot snapshot, Shot shot) {
    Pose drone = pose(snapshot, shot.drone());
    return new Sight(setting.scene(snapshot, shot.drone()), drone, shot.downward());
  }

  /**
   * The camera in the underside has no colours, and only the upper part of its picture is one: as
   * wide as three quarters of that are high. The rest is zero, which is green. Measured: 320 by 240
   * of 320 by 720 pixels (DTP #140).
   */
  private void filmBelow(Scene scene, Pose drone, Picture picture) {
    int width = picture.width();
    int height = Math.min(picture.height(), width * 3 / 4 / 2 * 2);
    camera.draw(scene, optics.below(drone, width, height), raster(picture, height));
    Arrays.fill(picture.y(), width * height, picture.y().length, (byte) 0);
    for (byte[] color : new byte[][] {picture.u(), picture.v()}) {
      Arrays.fill(color, 0, width * height / 4, NEUTRAL);
      Arrays.fill(color, width * height / 4, color.length, (byte) 0);
    }
  }

  private Raster raster(Picture picture, int height) {
    if (raster.isEmpty() || !raster.get().isOn(picture, height)) {
      raster = Optional.of(Raster.on(picture, height));
    }
    return raster.get();
  }

  private static Pose pose(SimSnapshot snapshot, int drone) {
    return snapshot.drones().get(drone - 1).state().motion().pose();
  }
}
