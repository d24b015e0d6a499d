package tellosimulator.view.video;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.WireTap;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.H264Encoder;

/** The video of all drones, as a window shows and keeps it. For any thread. */
public final class WindowVideo implements AutoCloseable {

  private final Supplier<SimSnapshot> snapshots;
  private final DroneOptics optics;
  private final SoftwareCameras cameras;
  private final VideoStreams streams;
  private final List<VideoCapture> captures;
  private volatile Consumer<VideoCapture.Report> reports = report -> {};

  /**
   * Films nothing before somebody wants pictures.
   *
   * @param snapshots the newest one
   * @param optics of the drones' cameras
   * @param folder where pictures are kept
   */
  public WindowVideo(Supplier<SimSnapshot> snapshots, DroneOptics optics, MediaFolder folder) {
    this(snapshots, optics, folder, () -> WireTap.NONE);
  }

  private WindowVideo(
      Supplier<SimSnapshot> snapshots,
      DroneOptics optics,
      MediaFolder folder,
      Supplier<WireTap> taps) {
    this.snapshots = snapshots;
    this.optics = optics;
    cameras = new SoftwareCameras(optics);
    streams = new VideoStreams(snapshots, cameras, H264Encoder::new, taps);
    captures =
        snapshots.get().drones().stream()
            .map(drone -> capture(drone.state().drone(), folder))
            .toList();
  }

  /** The video of a running simulation, whose drones film when they are told to. */
  public static WindowVideo of(
      OnlineSimulation simulation, DroneOptics optics, MediaFolder folder) {
    WindowVideo video = new WindowVideo(simulation::snapshot, optics, folder, simulation::tap);
    simulation.listen(video.streams);
    return video;
  }

  private VideoCapture capture(int drone, MediaFolder folder) {
    return new VideoCapture(
        new VideoCapture.Source(drone, stream(drone), () -> powered(drone)),
        folder,
        report -> reports.accept(report));
  }

  private boolean powered(int drone) {
    return snapshots.get().drones().get(drone - 1).state().phase() != FlightPhase.OFF;
  }

  /** The video of all drones. */
  public VideoStreams streams() {
    return streams;
  }

  /** The video of a drone. */
  public VideoStream stream(int drone) {
    return streams.stream(drone);
  }

  /** Keeps pictures of a drone. */
  public VideoCapture capture(int drone) {
    return captures.get(drone - 1);
  }

  /** The optics of the drones' cameras. */
  public DroneOptics optics() {
    return optics;
  }

  /** Tells somebody what became of pictures that were to be kept, on any thread. */
  public void onReport(Consumer<VideoCapture.Report> listener) {
    reports = listener;
  }

  /** What makes the scenes that drones film; whoever draws them too shares its textures. */
  public SceneBuilder scenes() {
    return cameras.scenes();
  }

  /** Moves on what a window shows; called once a pulse, on the JavaFX thread. */
  public void advance() {
    captures.forEach(VideoCapture::advance);
  }

  /** Ends all streams and films, and waits until they have ended. */
  @Override
  public void close() {
    streams.close();
    captures.forEach(VideoCapture::close);
  }
}
