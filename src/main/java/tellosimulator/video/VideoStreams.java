package tellosimulator.video;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.Encoders;

/** The video of all drones of a simulation, each on a thread of its own. For any thread. */
public final class VideoStreams implements SimListener, AutoCloseable {

  private final List<VideoStream> streams;

  /**
   * Films the drones of a simulation whenever somebody wants their pictures. Who makes one listens
   * to the simulation for it, or a drone that is told to film does so only when somebody looks.
   *
   * @param snapshots the newest one
   * @param sources makes a source of pictures for each drone
   */
  public VideoStreams(
      Supplier<SimSnapshot> snapshots, Supplier<FrameSource> sources, Encoders encoders) {
    streams =
        IntStream.rangeClosed(1, snapshots.get().drones().size())
            .mapToObj(
                drone ->
                    new VideoStream(drone, snapshots, new Film(drone, sources.get(), encoders)))
            .toList();
  }

  /**
   * Films the drones of a simulation whenever somebody wants their pictures.
   *
   * @param sources makes a source of pictures for each drone
   */
  public static VideoStreams of(
      OnlineSimulation simulation, Supplier<FrameSource> sources, Encoders encoders) {
    VideoStreams streams = new VideoStreams(simulation::snapshot, sources, encoders);
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
    for (int drone = 1; drone <= streams.size(); drone++) {
      if (event.drone() == drone || event.drone() == 0) {
        stream(drone).wake();
      }
    }
  }

  @Override
  public void close() {
    streams.forEach(VideoStream::end); // all of them, before it waits for one
    streams.forEach(VideoStream::close);
  }
}
