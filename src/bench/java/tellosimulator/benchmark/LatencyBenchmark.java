package tellosimulator.benchmark;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.Ticker;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.H264Encoder;

/**
 * How old a picture is when the whole of it has arrived: a drone on the ground is put elsewhere,
 * and the first picture that was taken of its new place is waited for.
 */
final class LatencyBenchmark {

  private static final int CHANGES = 100;
  private static final int WARM_UP = 100;

  /** A picture that was begun. */
  private record Begun(int number, Vec3 place) {}

  private final BlockingQueue<Begun> begun = new LinkedBlockingQueue<>();
  private final Random random = new Random(1);
  private final Ticker clock = new Ticker();
  private int pictures;

  private LatencyBenchmark() {}

  static Measurement latency() throws IOException {
    return Measurement.atMost(
        "From a change in the model to the last datagram of the picture that shows it, median of "
            + CHANGES,
        60,
        new Statistics(new LatencyBenchmark().measure()).median());
  }

  @SuppressWarnings("try") // the streams film as long as they are open
  private List<Double> measure() throws IOException {
    try (VideoSocket video = new VideoSocket();
        OnlineSimulation simulation = simulation(video.port());
        VideoStreams streams =
            VideoStreams.of(simulation, () -> noted(cameras().get()), H264Encoder::new)) {
      simulation.switchAllOn();
      int port = simulation.addresses(1).get(0).getPort();
      try (Operator operator = new Operator(port)) {
        operator.expect("command", "ok");
        operator.expect("streamon", "ok");
      }
      int received = 0;
      for (int i = 0; i < WARM_UP; i++) {
        video.awaitPicture();
        received++;
      }
      List<Double> times = new ArrayList<>();
      for (int i = 0; i < CHANGES; i++) {
        clock.pauseUntil(clock.nanos() + random.nextInt(40_000_000));
        Vec3 place = new Vec3(random.nextDouble(), random.nextDouble(), 0);
        begun.clear();
        long changed = System.nanoTime();
        simulation.carryOut(new Control.SetStart(1, place));
        int number = showing(place);
        while (received < number) {
          video.awaitPicture();
          received++;
        }
        times.add((System.nanoTime() - changed) * 1e-6);
      }
      return times;
    } catch (PortTakenException e) {
      throw new IOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(e);
    }
  }

  private int showing(Vec3 place) throws InterruptedException {
    Begun picture = begun.take();
    while (picture.place.minus(place).norm() > 1e-9) {
      picture = begun.take();
    }
    return picture.number;
  }

  private FrameSource noted(FrameSource source) {
    return (snapshot, camera, picture) -> {
      pictures++;
      Vec3 place = snapshot.drones().get(0).state().motion().position();
      begun.add(new Begun(pictures, place));
      source.film(snapshot, camera, picture);
    };
  }

  private static SoftwareCameras cameras() {
    return new SoftwareCameras(DroneOptics.DEFAULT);
  }

  private static OnlineSimulation simulation(int videoPort) {
    return new OnlineSimulation(
        SimConfig.DEFAULT.withStreamPorts(new StreamPorts(9, videoPort)),
        AddressPlan.portPerDrone(1, List.of(InetAddress.getLoopbackAddress()), 0),
        OptionalInt.empty(),
        List.of());
  }
}
