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

/**
 * The video of all drones, as a window shows and saves it. Thread-safe, except {@link #advance}.
 */
public final class WindowVideo implements AutoCloseable {

  private final Supplier<SimSnapshot> snapshots;
  private final DroneOptics optics;
  private final SoftwareCameras cameras;
  private final VideoStreams streams;
  private final List<VideoCapture> captures;
  private volatile Consumer<VideoCapture.Report> reports = report -> {};

  /**
   * Creates the video of all drones. Nothing is rendered until pictures are requested.
   *
   * @param snapshots supplies the newest snapshot
   * @param optics the optics of the drones' cameras
   * @param folder the folders for saved pictures and videos
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

  /** Returns the video of a running simulation. On command, the drones also stream to operators. */
  public static WindowVideo of(
      OnlineSimulation simulation, DroneOptics optics, MediaFolder folder) {
    WindowVideo video = new WindowVideo(simulation::snapshot, optics, folder, simulation::tap);
    video.streams.join(simulation);
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

  /** Returns the streams of all drones. */
  public VideoStreams streams() {
    return streams;
  }

  /** Returns the stream of a drone. */
  public VideoStream stream(int drone) {
    return streams.stream(drone);
  }

  /** Returns the capture of a drone's pictures. */
  public VideoCapture capture(int drone) {
    return captures.get(drone - 1);
  }

  /** Returns the optics of the drones' cameras. */
  public DroneOptics optics() {
    return optics;
  }

  /** Sets the listener for the results of saving pictures. It is called on any thread. */
  public void onReport(Consumer<VideoCapture.Report> listener) {
    reports = listener;
  }

  /**
   * Returns the builder of the scenes that drones film. Other renderers that use this builder share
   * its textures.
   */
  public SceneBuilder scenes() {
    return cameras.scenes();
  }

  /** Updates the state of the recordings. Must be called once per UI tick, on the JavaFX thread. */
  public void advance() {
    captures.forEach(VideoCapture::advance);
  }

  /** Stops all streams and recordings, and waits until they have ended. */
  @Override
  public void close() {
    streams.close();
    captures.forEach(VideoCapture::close);
  }
}
