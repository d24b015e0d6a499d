package tellosimulator.video;

import java.util.function.Supplier;
import tellosimulator.scenery.Stage;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareFrameSource;

/** Creates software cameras that share a render cache. For any thread. */
public final class SoftwareCameras implements Supplier<FrameSource> {

  private final Stage stage;
  private final RenderCache cache;
  private final DroneOptics optics;

  public SoftwareCameras(DroneOptics optics) {
    this(new Stage(), new RenderCache(ColorSpace.YUV), optics);
  }

  private SoftwareCameras(Stage stage, RenderCache cache, DroneOptics optics) {
    this.stage = stage;
    this.cache = cache;
    this.optics = optics;
  }

  /** Cameras with other optics, which share this render cache. */
  public SoftwareCameras withOptics(DroneOptics newOptics) {
    return new SoftwareCameras(stage, cache, newOptics);
  }

  /** What makes the scenes that they draw. */
  public Stage stage() {
    return stage;
  }

  /** One more camera; for one thread. */
  @Override
  public FrameSource get() {
    return new SoftwareFrameSource(cache, optics, stage::scene);
  }
}
