package tellosimulator.view.video;

import java.util.function.Supplier;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.H264Encoder;

/** The video of all drones, as a window shows and keeps it. For any thread. */
public final class WindowVideo implements AutoCloseable {

  private final DroneOptics optics;
  private final SoftwareCameras cameras;
  private final VideoStreams streams;

  /**
   * Films nothing before somebody wants pictures.
   *
   * @param snapshots the newest one
   * @param optics of the drones' cameras
   */
  public WindowVideo(Supplier<SimSnapshot> snapshots, DroneOptics optics) {
    this.optics = optics;
    cameras = new SoftwareCameras(optics);
    streams = new VideoStreams(snapshots, cameras, H264Encoder::new);
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
    streams.warmUp(cameras.get());
  }

  /** Ends all streams, and waits until they have ended. */
  @Override
  public void close() {
    streams.close();
  }
}
