package tellosimulator.view.video;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenery.Stage;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.Films;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.WarmUp;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.H264Encoder;

/** The video of all drones, as a window shows and keeps it. For any thread. */
public final class WindowVideo implements AutoCloseable {

  private final Supplier<SimSnapshot> snapshots;
  private final DroneOptics optics;
  private final SoftwareCameras cameras;
  private final SnapshotDesk desk = new SnapshotDesk();
  private final VideoStreams streams;
  private final WarmUp warmUp;
  private final List<Keeper> keepers;
  private volatile Consumer<VideoReport> reports = report -> {};
  private volatile Optional<Consumer<SnapshotOrder>> photographer = Optional.empty();

  /**
   * Films nothing before somebody wants pictures.
   *
   * @param snapshots the newest one
   * @param optics of the drones' cameras
   * @param album where pictures are kept
   */
  public WindowVideo(Supplier<SimSnapshot> snapshots, DroneOptics optics, Album album) {
    this.snapshots = snapshots;
    this.optics = optics;
    cameras = new SoftwareCameras(optics);
    streams =
        new VideoStreams(
            snapshots,
            new Films(() -> new SceneSnapshotSource(desk, cameras.get()), H264Encoder::new));
    warmUp = new WarmUp(new Films(cameras, H264Encoder::new));
    keepers =
        snapshots.get().drones().stream()
            .map(drone -> keeper(drone.state().drone(), album))
            .toList();
  }

  /** The video of a running simulation, whose drones film when they are told to. */
  public static WindowVideo of(OnlineSimulation simulation, DroneOptics optics, Album album) {
    WindowVideo video = new WindowVideo(simulation::snapshot, optics, album);
    simulation.listen(video.streams);
    return video;
  }

  private Keeper keeper(int drone, Album album) {
    return new Keeper(
        new Keeper.Source(drone, stream(drone), () -> powered(drone)),
        album,
        report -> reports.accept(report));
  }

  private boolean powered(int drone) {
    return snapshots.get().drones().get(drone - 1).state().phase() != FlightPhase.OFF;
  }

  /** The video of a drone. */
  public VideoStream stream(int drone) {
    return streams.stream(drone);
  }

  /** Keeps pictures of a drone. */
  public Keeper keeper(int drone) {
    return keepers.get(drone - 1);
  }

  /** The optics of the drones' cameras. */
  public DroneOptics optics() {
    return optics;
  }

  /** Tells somebody what became of pictures that were to be kept, on any thread. */
  public void onReport(Consumer<VideoReport> listener) {
    reports = listener;
  }

  /** What makes the scenes that drones film; whoever draws them too shares its textures. */
  public Stage stage() {
    return cameras.stage();
  }

  /**
   * Lets a window's scene be photographed for the drones' video, if that is cheaper than to draw
   * it.
   *
   * @param newPhotographer fills an order, on the JavaFX thread
   */
  public void photographBy(Consumer<SnapshotOrder> newPhotographer) {
    photographer = Optional.of(newPhotographer);
  }

  /** Who takes pictures of the window's scene. */
  Consumer<SnapshotOrder> photographer() {
    return photographer.orElseThrow();
  }

  /** Tells somebody, on any thread, when a picture of the window's scene is waited for. */
  public void onOrder(Runnable listener) {
    desk.onOrder(listener);
  }

  /** Photographs no scene any more. */
  public void photographNoMore() {
    photographer = Optional.empty();
    desk.close();
  }

  /**
   * Lets the Java machine compile what filming takes, in the background, and tries out what
   * photographs cost.
   */
  public void warmUp() {
    warmUp.begin(snapshots);
    if (photographer.isPresent()) {
      desk.open();
    }
  }

  /** Moves on what a window shows; called once a pulse, on the JavaFX thread. */
  public void advance() {
    keepers.forEach(Keeper::advance);
    photographer.ifPresent(desk::serve);
  }

  /** Ends all streams and films, and waits until they have ended. */
  @Override
  public void close() {
    warmUp.close();
    streams.close();
    keepers.forEach(Keeper::close);
  }
}
