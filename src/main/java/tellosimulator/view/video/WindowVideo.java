package tellosimulator.view.video;

import java.util.function.Supplier;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenery.Stage;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.camera.Props;
import tellosimulator.video.camera.SoftwareFrameSource;
import tellosimulator.video.codec.H264Encoder;

/** The video of all drones, as a window shows and keeps it. For any thread. */
public final class WindowVideo implements AutoCloseable {

  private final DroneOptics optics;
  private final Supplier<FrameSource> sources;
  private final VideoStreams streams;

  /**
   * Films nothing before somebody wants pictures.
   *
   * @param snapshots the newest one
   * @param optics of the drones' cameras
   */
  public WindowVideo(Supplier<SimSnapshot> snapshots, DroneOptics optics) {
    this.optics = optics;
    Stage stage = new Stage();
    Props props = new Props(ColorSpace.YUV);
    sources = () -> new SoftwareFrameSource(props, optics, stage::scene);
    streams = new VideoStreams(snapshots, sources, H264Encoder::new);
  }

  /** The video of a running simulation, whose drones film when they are told to. */
  public static WindowVideo of(OnlineSimulation simulation, DroneOptics optics) {
    WindowVideo video = new WindowVideo(simulation::snapshot, optics);
    simulation.listen(video.streams);
    return video;
  }

  /** The video of a drone. */
  public VideoStream stream(int drone) {
    return streams.stream(drone);
  }

  /** The optics of the drones' cameras. */
  public DroneOptics optics() {
    return optics;
  }

  /** Lets the Java machine compile what filming takes, in the background. */
  public void warmUp() {
    streams.warmUp(sources.get());
  }

  /** Ends all streams, and waits until they have ended. */
  @Override
  public void close() {
    streams.close();
  }
}
