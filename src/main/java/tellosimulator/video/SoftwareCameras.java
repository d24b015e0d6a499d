package tellosimulator.video;

import java.util.function.Supplier;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareFrameSource;

/** Creates software cameras that share a render cache. Thread-safe. */
public final class SoftwareCameras implements Supplier<FrameSource> {

  private final SceneBuilder scenes = new SceneBuilder();
  private final RenderCache cache = new RenderCache(ColorSpace.YUV);
  private final DroneOptics optics;

  public SoftwareCameras(DroneOptics optics) {
    this.optics = optics;
  }

  /** The builder for the scenes that the cameras render. */
  public SceneBuilder scenes() {
    return scenes;
  }

  /** Returns a new camera. The camera itself is not thread-safe. */
  @Override
  public FrameSource get() {
    return new SoftwareFrameSource(cache, optics, scenes::scene);
  }
}
