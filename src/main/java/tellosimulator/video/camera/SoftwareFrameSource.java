package tellosimulator.video.camera;

import java.util.Arrays;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.model.DroneState;
import tellosimulator.scenery.Scene;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** Renders the drones' cameras with a software camera. Used by one thread at a time. */
public final class SoftwareFrameSource implements FrameSource {

  /** Creates the scene of a snapshot. */
  @FunctionalInterface
  public interface SceneFactory {

    /**
     * Returns the scene for the cameras of a drone. The scene contains everything but the drone
     * itself.
     */
    Scene scene(SimSnapshot snapshot, int drone);
  }

  /** The value of Cb and Cr for grey. */
  private static final byte NEUTRAL = (byte) 128;

  private final SoftwareCamera renderer;
  private final DroneOptics optics;
  private final SceneFactory scenes;
  private Optional<FrameBuffer> frameBuffer = Optional.empty();

  /**
   * Creates a source.
   *
   * @param cache a cache for {@link ColorSpace#YUV}; shared by all sources, because it takes much
   *     memory
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
    int height = height(camera, picture);
    if (camera.downward()) {
      filmDownward(view.scene(), view.drone(), picture, height);
    } else {
      PinholeCamera ahead = optics.ahead(view.drone(), picture.width(), height);
      renderer.draw(view.scene(), ahead, frameBuffer(picture, height));
    }
    int pixels = picture.width() * height;
    SensorNoise.addTo(picture.y(), pixels, snapshot.seed(), state(snapshot, camera.drone()));
  }

  @Override
  public Optional<CameraView> view(SimSnapshot snapshot, CameraId camera) {
    return Optional.of(seen(snapshot, camera));
  }

  @Override
  public Picture blankPhoto() {
    return new Picture(optics.photoWidth(), optics.photoHeight());
  }

  private CameraView seen(SimSnapshot snapshot, CameraId camera) {
    Pose drone = state(snapshot, camera.drone()).motion().pose();
    return new CameraView(scenes.scene(snapshot, camera.drone()), drone, camera.downward());
  }

  /**
   * Renders the image of the downward camera. The image has no chroma, and covers only the upper
   * part of the frame. The rest of the frame is zero, which appears green.
   */
  private void filmDownward(Scene scene, Pose drone, Picture picture, int height) {
    int width = picture.width();
    renderer.draw(scene, optics.below(drone, width, height), frameBuffer(picture, height));
    Arrays.fill(picture.y(), width * height, picture.y().length, (byte) 0);
    for (byte[] chroma : new byte[][] {picture.u(), picture.v()}) {
      Arrays.fill(chroma, 0, width * height / 4, NEUTRAL);
      Arrays.fill(chroma, width * height / 4, chroma.length, (byte) 0);
    }
  }

  /**
   * Returns the height of a camera's image in a picture [pixels]. The downward camera's image has
   * an aspect ratio of 4:3. Measured: it covers 320 by 240 pixels of a picture of 320 by 720 (DTP
   * #140).
   */
  private static int height(CameraId camera, Picture picture) {
    return camera.downward()
        ? Math.min(picture.height(), picture.width() * 3 / 4 / 2 * 2)
        : picture.height();
  }

  private FrameBuffer frameBuffer(Picture picture, int height) {
    if (frameBuffer.isEmpty() || !frameBuffer.get().isOn(picture, height)) {
      frameBuffer = Optional.of(FrameBuffer.on(picture, height));
    }
    return frameBuffer.get();
  }

  private static DroneState state(SimSnapshot snapshot, int drone) {
    return snapshot.drones().get(drone - 1).state();
  }
}
