package tellosimulator.video;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.world.Room;

/**
 * Drones that are on and stream video, with real sockets on loopback, and a program that commands
 * them. The camera's image has a single colour, whose luma depends on the drone's number.
 */
final class FilmedDrones implements AutoCloseable {

  /** Luma of drone 1's picture; that of each further drone is higher by {@link #STEP}. */
  static final int FIRST = 60;

  static final int STEP = 40;

  /** Luma of the downward camera's picture. */
  static final int BELOW = 20;

  private static final FrameSource ONE_COLOR =
      (snapshot, shot, picture) -> {
        int level = shot.downward() ? BELOW : FIRST + STEP * (shot.drone() - 1);
        Arrays.fill(picture.y(), (byte) level);
        Arrays.fill(picture.u(), (byte) 128);
        Arrays.fill(picture.v(), (byte) 128);
      };

  private final OnlineSimulation simulation;
  private final VideoStreams streams;
  private final DatagramSocket client;

  /** Starts the drones. Each drone's video goes to its own port. */
  FilmedDrones(Profile profile, int... videoPorts) throws IOException {
    List<StreamPorts> streamPorts =
        IntStream.of(videoPorts).mapToObj(port -> new StreamPorts(9, port)).toList();
    Product product = new Product(profile, Behavior.REPORT);
    List<Pose> starts = Formation.row(videoPorts.length, Vec3.ZERO, Room.DEFAULT);
    SimConfig config =
        SimConfig.DEFAULT.withDrones(
            IntStream.range(0, starts.size())
                .mapToObj(i -> DroneSetup.at(starts.get(i), product, streamPorts.get(i)))
                .toList());
    AddressPlan plan =
        AddressPlan.portPerDrone(videoPorts.length, List.of(InetAddress.getLoopbackAddress()), 0);
    simulation = new OnlineSimulation(config, plan, OptionalInt.empty(), List.of());
    streams = VideoStreams.of(simulation, () -> ONE_COLOR, H264Encoder::new);
    try {
      simulation.switchAllOn();
    } catch (PortTakenException e) {
      throw new IOException(e);
    }
    client = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    client.setSoTimeout(10_000);
  }

  VideoStreams streams() {
    return streams;
  }

  InetSocketAddress address(int drone) {
    return simulation.addresses(drone).get(0);
  }

  void power(int drone, boolean on) throws PortTakenException {
    simulation.carryOut(new Control.Power(drone, on));
  }

  /** Commands a drone and waits for its reply. */
  String ask(int drone, String text) throws IOException {
    return ask(client, drone, text);
  }

  /** Commands a drone from another program's socket and waits for its reply. */
  String ask(DatagramSocket from, int drone, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    from.send(new DatagramPacket(bytes, bytes.length, address(drone)));
    DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
    from.receive(reply);
    return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.ISO_8859_1).strip();
  }

  @Override
  public void close() {
    client.close();
    streams.close();
    simulation.close();
  }
}
