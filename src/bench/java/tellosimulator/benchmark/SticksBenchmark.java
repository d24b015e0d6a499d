package tellosimulator.benchmark;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;

/**
 * How fast twenty drones fly circles with the sticks of the app's protocol, fifty packets a second
 * each, compared with {@code rc} in texts.
 */
final class SticksBenchmark {

  private static final int DRONES = 20;
  private static final Room HALL = new Room(40, 40, 5);
  private static final double APART = 1.5;

  /** Fifty packets a second: one in each fourth step of 5 ms. */
  private static final int STEPS_FOR_EACH = 4;

  private static final double RUN_SECONDS = 2;
  private static final int RUNS = 5;

  private SticksBenchmark() {}

  static List<Measurement> all() {
    Circles texts = new Circles(List.of("command", "takeoff"), "rc 0 30 0 60");
    Circles packets =
        new Circles(
            List.of("conn_req:\u0096\u0017", packet("cc58007c6854000000b289")),
            packet("ccb0007f605000000000342600190b0000000000ba03"));
    List<Double> ratios = new ArrayList<>();
    for (int run = 0; run <= RUNS; run++) { // the first one warms up
      double ratio = packets.factor() / texts.factor();
      if (run > 0) {
        ratios.add(ratio);
      }
    }
    double median = new Statistics(ratios).median();
    return List.of(
        new Measurement(
            DRONES + " drones by sticks at 50 Hz, speed compared with `rc`",
            "at least 1 ×",
            String.format(Locale.ROOT, "%.2f ×", median),
            median >= 1));
  }

  private static String packet(String hex) {
    return WireText.decode(HexFormat.of().parseHex(hex));
  }

  /** Drones that are in the air and get the same sticks all the time. */
  private static final class Circles {

    private final Simulation simulation;
    private final Peer peer =
        new Peer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 9),
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 8889));
    private final byte[] sticks;
    private int steps;

    Circles(List<String> begin, String sticks) {
      this.sticks = WireText.encode(sticks);
      List<Pose> starts =
          IntStream.range(0, DRONES)
              .mapToObj(i -> new Vec3((i % 5 - 2) * APART, (i / 5 - 2) * APART, 0))
              .map(place -> new Pose(place, Attitude.LEVEL))
              .toList();
      simulation =
          new Simulation(
              SimConfig.DEFAULT.withRoom(HALL, starts).withArena(Arena.DEFAULT.withRoom(HALL)),
              drone -> datagram -> {},
              List.of());
      for (int drone = 1; drone <= DRONES; drone++) {
        simulation.control(new Control.Power(drone, true));
        for (String text : begin) {
          simulation.submit(drone, peer, WireText.encode(text));
        }
      }
      pass(1000);
    }

    private void pass(int count) {
      for (int i = 0; i < count; i++) {
        if (steps % STEPS_FOR_EACH == 0) {
          for (int drone = 1; drone <= DRONES; drone++) {
            simulation.submit(drone, peer, sticks);
          }
        }
        simulation.step();
        steps++;
      }
    }

    /** Returns simulated over wall time, measured for some wall seconds. */
    double factor() {
      for (int drone = 1; drone <= DRONES; drone++) {
        simulation.control(new Control.SetBattery(drone, 100));
      }
      double simulated = simulation.snapshot().time().seconds();
      long start = System.nanoTime();
      double wall = 0;
      while (wall < RUN_SECONDS) {
        pass(200);
        wall = (System.nanoTime() - start) * 1e-9;
      }
      if (!simulation.snapshot().drones().get(0).state().phase().flying()) {
        throw new IllegalStateException("the drones do not fly");
      }
      return (simulation.snapshot().time().seconds() - simulated) / wall;
    }
  }
}
