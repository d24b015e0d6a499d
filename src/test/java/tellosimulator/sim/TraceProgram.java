package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.TextPort;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

/**
 * Flies two drones along a fixed script and prints the SHA-256 of all results: each step's motion,
 * each reply, each state line, each event. Arguments: the pace ({@code stepped}, {@code
 * stepped-max}, {@code max} or a time factor) and the seed.
 */
public final class TraceProgram implements SimListener {

  private static final List<String> SCRIPT =
      List.of(
          "command",
          "takeoff",
          "battery?",
          "rc 0 40 10 30",
          "curve 25 -25 0 25 -75 0 60",
          "rc 0 0 0 0",
          "flip l",
          "foo",
          "stop",
          "cw 45",
          "tof?",
          "land");

  private static final int DRONES = 2;

  /** Faults that lose no reply, because the next command waits for it. */
  private static final List<String> FAULTS =
      List.of(
          "delay commands replies 20ms spread 30ms",
          "delay state 50ms spread 40ms at 3s",
          "loss state 20% burst 2",
          "duplicate state 10% drone 2",
          "reorder state 10% after forward",
          "corrupt state 5% for 10s");

  private final MessageDigest digest;
  private final CountDownLatch done = new CountDownLatch(DRONES);
  private final int[] next = new int[DRONES];
  private final List<String> states = new ArrayList<>();
  private final Simulation simulation;

  private TraceProgram(TimeFactor factor, long seed) throws NoSuchAlgorithmException {
    digest = MessageDigest.getInstance("SHA-256");
    Room room = new Room(8, 8, 4);
    simulation =
        new Simulation(
            SimConfig.DEFAULT
                .withProduct(Profile.EDU, Behavior.MEASURED)
                .withLink(LinkPreset.IDEAL)
                .withFaults(FAULTS.stream().map(Fault::of).toList())
                .withRoom(room, Formation.row(DRONES, Vec3.ZERO, room))
                .withTimeFactor(factor)
                .withSeed(seed),
            drone -> TextPort.of(text -> replied(drone, text), states::add),
            List.of(this));
    for (int drone = 1; drone <= DRONES; drone++) {
      simulation.control(new Control.Power(drone, true));
      sendNext(drone);
    }
  }

  /** Prints the hash. */
  public static void main(String[] args) throws Exception {
    long seed = Long.parseLong(args[1]);
    System.out.println(trace(args[0], seed));
  }

  static String trace(String pace, long seed) throws Exception {
    boolean stepped = pace.startsWith("stepped");
    boolean max = pace.endsWith("max");
    double value = stepped || max ? 1 : Double.parseDouble(pace);
    TraceProgram program = new TraceProgram(max ? TimeFactor.MAX : new TimeFactor(value), seed);
    if (stepped) {
      while (program.done.getCount() > 0) {
        program.simulation.step();
      }
    } else {
      SimulationLoop loop = new SimulationLoop(program.simulation);
      program.done.await();
      loop.close();
    }
    return HexFormat.of().formatHex(program.digest.digest());
  }

  private void replied(int drone, String text) {
    add(drone + text);
    if (!text.equals("forced stop")) {
      sendNext(drone);
    }
  }

  /** Sends the next command; the reply to the last one ends the trace of a drone. */
  private void sendNext(int drone) {
    int index = next[drone - 1]++;
    if (index >= SCRIPT.size()) {
      done.countDown();
      return;
    }
    String command = SCRIPT.get(index);
    simulation.submit(
        drone, new Peer(loopback(9000 + drone), loopback(8879)), WireText.encode(command));
    if (command.startsWith("rc ")) {
      sendNext(drone);
    }
  }

  @Override
  public void event(SimEvent event) {
    if (!(event instanceof SimEvent.TimeLost)) { // about the machine, not the flight
      add(event.line());
    }
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    if (done.getCount() == 0) {
      return;
    }
    states.forEach(this::add);
    states.clear();
    snapshot.drones().forEach(drone -> add(drone.state().motion()));
  }

  private void add(Motion motion) {
    Vec3 position = motion.position();
    Vec3 velocity = motion.velocity();
    Attitude attitude = motion.attitude();
    for (double value :
        new double[] {
          position.x(),
          position.y(),
          position.z(),
          velocity.x(),
          velocity.y(),
          velocity.z(),
          attitude.w(),
          attitude.x(),
          attitude.y(),
          attitude.z()
        }) {
      digest.update(ByteBuffer.allocate(Double.BYTES).putDouble(value).array());
    }
  }

  private void add(String text) {
    if (done.getCount() > 0) {
      digest.update(text.getBytes(StandardCharsets.UTF_8));
    }
  }

  private static InetSocketAddress loopback(int port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }
}
