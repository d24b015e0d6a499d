package tellosimulator.video.camera;

import java.util.Arrays;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.scenery.Scene;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** Renders the drones' cameras with a software camera. For one thread at a time. */
public final class SoftwareFrameSource implements FrameSource {

  /** Makes the scene of a snapshot. */
  @FunctionalInterface
  public interface SceneFactory {

    /** What the cameras of a drone see: all but the drone itself. */
    Scene scene(SimSnapshot snapshot, int drone);
  }

  /** Cb and Cr of grey. */
  private static final byte NEUTRAL = (byte) 128;

  private final SoftwareCamera renderer;
  private final DroneOptics optics;
  private final SceneFactory scenes;
  private Optional<FrameBuffer> frameBuffer = Optional.empty();

  /**
   * @param cache for {@link ColorSpace#YUV}; shared by all sources, as it takes much memory
   */
  public SoftwareFrameSource(RenderCache cache, DroneOptics optics, SceneFactory scenes) {
    if (cache.space() != ColorSpace.YUV) {
      throw new IllegalArgumentException("cache is for " + cache.space() + ", but must be for YUV");
    }
    renderer = new SoftwareCamera(cache);
    this.optics = optics;
    this.scenes = scenes;
  }

  @Override
  public void film(SimSnapshot snapshot, CameraId camera, Picture picture) {
    CameraView view = seen(snapshot, camera);
    if (camera.downward()) {
      filmDownward(view.scene(), view.drone(), picture);
    } else {
      PinholeCamera ahead = optics.ahead(view.drone(), picture.width(), picture.height());
      renderer.draw(view.scene(), ahead, frameBuffer(picture, picture.height()));
    }
  }

  @Override
  public Optional<CameraView> view(SimSnapshot snapshot, CameraId camera) {
    return Optional.of(seen(snapshot, camera));
  }

  private CameraView seen(SimSnapshot snapshot, CameraId camera) {
    Pose drone = pose(snapshot, camera.drone());
    return new CameraView(scenes.scene(snapshot, camera.drone()), drone, camera.downward());
  }

  /**
   * The downward camera has no chroma, and only the upper part of the frame is its image, with an
   * aspect ratio of 4:3. The rest is zero, which is green. Measured: 320 by 240 of 320 by 720
   * pixels (DTP #140).
   */
  private void filmDownward(Scene scene, Pose drone, Picture picture) {
    int width = picture.width();
    int height = Math.min(picture.height(), width * 3 / 4 / 2 * 2);
    renderer.draw(scene, optics.below(drone, width, height), frameBuffer(picture, height));
    Arrays.fill(picture.y(), width * height, picture.y().length, (byte) 0);
    for (byte[] chroma : new byte[][] {picture.u(), picture.v()}) {
      Arrays.fill(chroma, 0, width * height / 4, NEUTRAL);
      Arrays.fill(chroma, width * height / 4, chroma.length, (byte) 0);
    }
  }

  private FrameBuffer frameBuffer(Picture picture, int height) {
    if (frameBuffer.isEmpty() || !frameBuffer.get().isOn(picture, height)) {
      frameBuffer = Optional.of(FrameBuffer.on(picture, height));
    }
    return frameBuffer.get();
  }

  private static Pose pose(SimSnapshot snapshot, int drone) {
    return snapshot.drones().get(drone - 1).state().motion().pose();
  }
}
