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

  private final Stage stage;
  private final Props props;
  private final DroneOptics optics;

  public SoftwareCameras(DroneOptics optics) {
    this(new Stage(), new Props(ColorSpace.YUV), optics);
  }

  private SoftwareCameras(Stage stage, Props props, DroneOptics optics) {
    this.stage = stage;
    this.props = props;
    this.optics = optics;
  }

  /** Cameras with other optics, which share with these what they draw. */
  public SoftwareCameras withOptics(DroneOptics newOptics) {
    return new SoftwareCameras(stage, props, newOptics);
  }

  /** What makes the scenes that they draw. */
  public Stage stage() {
    return stage;
  }

  /** One more camera; for one thread. */
  @Override
  public FrameSource get() {
    return new SoftwareFrameSource(props, optics, stage::scene);
  }
}
