package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.WireTap;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.VideoEncoder;

/** The video of all drones of a simulation, each on its own thread. Thread-safe. */
public final class VideoStreams implements SimListener, AutoCloseable {

  private final Supplier<SimSnapshot> snapshots;
  private final List<VideoStream> streams;

  /**
   * Creates streams for the drones of a simulation. They render only while pictures are requested.
   * The caller must register this object as a listener of the simulation; otherwise, drones start
   * to stream only when watched.
   *
   * @param snapshots supplies the newest snapshot
   * @param cameras creates a drone's camera when it is first needed
   * @param encoders creates an encoder for each frame size
   */
  public VideoStreams(
      Supplier<SimSnapshot> snapshots,
      Supplier<FrameSource> cameras,
      VideoEncoder.Factory encoders) {
    this(snapshots, cameras, encoders, () -> WireTap.NONE);
  }

  /**
   * Creates streams for the drones of a simulation. They render only while pictures are requested.
   * The caller must register this object as a listener of the simulation.
   *
   * @param snapshots supplies the newest snapshot
   * @param cameras creates a drone's camera when it is first needed
   * @param encoders creates an encoder for each frame size
   * @param taps supplies the tap for sent datagrams
   */
  public VideoStreams(
      Supplier<SimSnapshot> snapshots,
      Supplier<FrameSource> cameras,
      VideoEncoder.Factory encoders,
      Supplier<WireTap> taps) {
    this.snapshots = snapshots;
    streams =
        IntStream.rangeClosed(1, snapshots.get().drones().size())
            .mapToObj(
                drone ->
                    new VideoStream(
                        drone,
                        snapshots,
                        () -> new FramePipeline(drone, cameras.get(), encoders),
                        taps))
            .toList();
  }

  /**
   * Creates streams for the drones of a simulation, and registers them as a listener of it.
   *
   * @param cameras creates a drone's camera when it is first needed
   * @param encoders creates an encoder for each frame size
   */
  public static VideoStreams of(
      OnlineSimulation simulation, Supplier<FrameSource> cameras, VideoEncoder.Factory encoders) {
    VideoStreams streams =
        new VideoStreams(simulation::snapshot, cameras, encoders, simulation::tap);
    streams.join(simulation);
    return streams;
  }

  /** Registers these streams as a listener of a simulation, and as the camera of its drones. */
  public void join(OnlineSimulation simulation) {
    simulation.listen(this);
    simulation.setCamera(
        (drone, quality) -> Optional.of(stream(drone).photo(snapshots.get(), quality)));
  }

  /** Returns the stream of a drone. */
  public VideoStream stream(int drone) {
    return streams.get(drone - 1);
  }

  /** Notifies the streams of an event, which may start or stop video. */
  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.RunStarted) {
      streams.forEach(VideoStream::restart);
    }
    if (!(event instanceof SimEvent.ForDrone one)) {
      streams.forEach(VideoStream::wake);
      return;
    }
    if (event instanceof SimEvent.CommandReceived command && fromOperator(command)) {
      stream(one.drone()).heard();
    }
    stream(one.drone()).happened();
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    for (int i = 0; i < streams.size(); i++) {
      streams.get(i).stepped(snapshot.drones().get(i).state().video());
    }
  }

  private boolean fromOperator(SimEvent.CommandReceived command) {
    return snapshots.get().drones().get(command.drone() - 1).link().operator().stream()
        .anyMatch(operator -> operator.host().equals(command.peer().host()));
  }

  @Override
  public void close() {
    streams.forEach(VideoStream::end); // ends all before waiting for any
    streams.forEach(VideoStream::close);
  }
}
