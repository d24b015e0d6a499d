package tellosimulator.video;

import java.util.function.Supplier;
import tellosimulator.scenery.Stage;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.camera.Props;
import tellosimulator.video.camera.SoftwareFrameSource;

/** Makes software cameras that share what they draw. For any thread. */
public final class SoftwareCameras implements Supplier<FrameSource> {

  private final Stage stage = new Stage();
  private final Props props = new Props(ColorSpace.YUV);
  private final DroneOptics optics;

  public SoftwareCameras(DroneOptics optics) {
    this.optics = optics;
  }

  /** One more camera; for one thread. */
  @Override
  public FrameSource get() {
    return new SoftwareFrameSource(props, optics, stage::scene);
  }
}
