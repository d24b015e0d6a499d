package tellosimulator.benchmark;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.command.DronePort;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkDirection;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.DatagramSender;
import tellosimulator.network.Ports;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/**
 * How much faster than the wall clock drones fly on one thread, each flying a tour by commands and
 * formatting its state lines.
 */
final class SpeedBenchmark {

  private static final List<String> TOUR =
      List.of(
          "command",
          "takeoff",
          "forward 50",
          "cw 90",
          "go 50 50 20 60",
          "curve 25 -25 0 25 -75 0 40",
          "rc 0 30 0 20",
          "up 40",
          "rc 0 0 0 0",
          "flip f",
          "back 100",
          "land");

  private static final Room HALL = new Room(20, 20, 5);
  private static final Shape.Box BOX = new Shape.Box(0.2, 0.2, 0.2);

  /** No box is nearer to a start than this [m]: it would be in the way of the takeoff. */
  private static final double CLEAR = 0.25;

  private static final int ROW = 10;
  private static final double APART = 0.6;

  private static final double WARM_UP_SECONDS = 3;
  private static final double RUN_SECONDS = 2;
  private static final int RUNS = 5;
  private static final int STEPS_AT_ONCE = 200;

  private SpeedBenchmark() {}

  private static Measurement measure(int drones, int obstacles, int target) {
    Tour tour = new Tour(drones, obstacles);
    tour.factor(WARM_UP_SECONDS);
    List<Double> factors =
        IntStream.range(0, RUNS).mapToObj(run -> tour.factor(RUN_SECONDS)).toList();
    double median = new Statistics(factors).median();
    return new Measurement(
        drones
            + (drones == 1 ? " drone" : " drones")
            + (obstacles == 0 ? "" : " over " + obstacles + " obstacles")
            + ", simulated over wall time",
        "at least " + target + " ×",
        String.format(Locale.ROOT, "%.0f ×", median),
        median >= target);
  }

  /** Drones that fly their tour again and again, each sending the next command on a reply. */
  private static final class Tour {

    private final Simulation simulation;
    private final Map<Integer, Integer> next = new HashMap<>();
    private long lines;

    Tour(int drones, int obstacles) {
      List<Pose> starts = square(drones);
      DatagramPort port = new Sink();
      Peer peer =
          new Peer(new InetSocketAddress(InetAddress.getLoopbackAddress(), 9), port.address());
      DronePort states = new DatagramSender(new Ports(List.of(port)), OptionalInt.empty());
      simulation =
          new Simulation(
              SimConfig.DEFAULT
                  .withRoom(HALL, starts)
                  .withArena(Arena.DEFAULT.withRoom(HALL).withObstacles(boxes(obstacles, starts))),
              drone ->
                  datagram -> {
                    if (datagram.direction() == LinkDirection.STATE) {
                      states.send(datagram);
                    } else {
                      fly(drone, peer);
                    }
                  },
              List.of());
      for (int drone = 1; drone <= drones; drone++) {
        simulation.control(new Control.Power(drone, true));
        fly(drone, peer);
      }
    }

    /** In rows of ten in the middle of the hall, so that no tour reaches a wall. */
    private static List<Pose> square(int drones) {
      return IntStream.range(0, drones)
          .mapToObj(i -> new Vec3(i / ROW - ROW / 2, i % ROW - ROW / 2, 0).times(APART))
          .map(place -> new Pose(place, Attitude.LEVEL))
          .toList();
    }

    /** Low boxes all over the floor: drones fly over them, and some land on them. */
    private static List<Obstacle> boxes(int count, List<Pose> starts) {
      SplittableRandom random = new SplittableRandom(1);
      double reach = (HALL.depth() - BOX.depth()) / 2;
      return Stream.generate(
              () -> new Vec3(random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), 0))
          .filter(
              place ->
                  starts.stream().noneMatch(start -> start.position().distanceTo(place) < CLEAR))
          .limit(count)
          .map(place -> new Obstacle("box", BOX, place, place.x(), ObstacleAppearance.DEFAULT))
          .toList();
    }

    private void fly(int drone, Peer peer) {
      int index = next.merge(drone, 1, Integer::sum) - 1;
      String command = TOUR.get(index % TOUR.size());
      if (command.equals("command")) {
        simulation.control(new Control.SetBattery(drone, 100));
        simulation.control(new Control.Reset(drone)); // all tours go the same way
      }
      simulation.submit(drone, peer, WireText.encode(command));
      if (command.startsWith("rc ")) {
        fly(drone, peer);
      }
    }

    /** Runs for some wall seconds. */
    double factor(double seconds) {
      double simulated = simulation.snapshot().time().seconds();
      long start = System.nanoTime();
      double wall = 0;
      while (wall < seconds) {
        for (int i = 0; i < STEPS_AT_ONCE; i++) {
          simulation.step();
        }
        wall = (System.nanoTime() - start) * 1e-9;
      }
      double passed = simulation.snapshot().time().seconds() - simulated;
      if (lines == 0) {
        throw new IllegalStateException("no state line was formatted");
      }
      return passed / wall;
    }

    /** Takes state lines and drops them. */
    private final class Sink implements DatagramPort {
      private final InetSocketAddress address =
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 8879);

      @Override
      public InetSocketAddress address() {
        return address;
      }

      @Override
      public void send(byte[] bytes, InetSocketAddress to) {
        lines++;
      }

      @Override
      public void close() {}
    }
  }

  static List<Measurement> all() {
    List<Measurement> rows = new ArrayList<>();
    rows.add(measure(1, 0, 5000));
    rows.add(measure(10, 0, 500));
    rows.add(measure(100, 0, 50));
    rows.add(measure(100, 200, 20));
    return rows;
  }
}
