package tellosimulator.video;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.WireTap;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.VideoEncoder;

/** The video of all drones of a simulation, each on a thread of its own. For any thread. */
public final class VideoStreams implements SimListener, AutoCloseable {

  private final Supplier<SimSnapshot> snapshots;
  private final List<VideoStream> streams;

  /**
   * Films the drones of a simulation whenever somebody wants their pictures. Who makes one listens
   * to the simulation for it, or a drone that is told to film does so only when somebody looks.
   *
   * @param snapshots the newest one
   * @param cameras creates a camera for each drone when it films first
   * @param encoders creates an encoder for each frame size
   */
  public VideoStreams(
      Supplier<SimSnapshot> snapshots,
      Supplier<FrameSource> cameras,
      VideoEncoder.Factory encoders) {
    this(snapshots, cameras, encoders, () -> WireTap.NONE);
  }

  /**
   * Films the drones of a simulation whenever somebody wants their pictures. Who makes one listens
   * to the simulation for it.
   *
   * @param snapshots the newest one
   * @param cameras creates a camera for each drone when it films first
   * @param encoders creates an encoder for each frame size
   * @param taps who sees what is sent
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
                        drone, snapshots, () -> new Film(drone, cameras.get(), encoders), taps))
            .toList();
  }

  /**
   * Films the drones of a simulation whenever somebody wants their pictures.
   *
   * @param cameras creates a camera for each drone when it films first
   * @param encoders creates an encoder for each frame size
   */
  public static VideoStreams of(
      OnlineSimulation simulation, Supplier<FrameSource> cameras, VideoEncoder.Factory encoders) {
    VideoStreams streams =
        new VideoStreams(simulation::snapshot, cameras, encoders, simulation::tap);
    simulation.listen(streams);
    return streams;
  }

  /** The video of a drone. */
  public VideoStream stream(int drone) {
    return streams.get(drone - 1);
  }

  /** A drone was told something, perhaps to film. */
  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.Restarted) {
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

  private boolean fromOperator(SimEvent.CommandReceived command) {
    return snapshots.get().drones().get(command.drone() - 1).link().operator().stream()
        .anyMatch(operator -> operator.host().equals(command.peer().host()));
  }

  @Override
  public void close() {
    streams.forEach(VideoStream::end); // all of them, before it waits for one
    streams.forEach(VideoStream::close);
  }
}
