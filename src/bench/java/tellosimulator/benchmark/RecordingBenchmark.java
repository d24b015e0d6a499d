package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkDirection;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalWatch;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.DatagramSender;
import tellosimulator.network.Ports;
import tellosimulator.network.UdpPort;
import tellosimulator.network.WireTap;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Room;

/**
 * What recording a flight costs: the simulation's thread with and without a recorder in turns, a
 * hundred drones at fifty times real time, and the size of an hour.
 */
final class RecordingBenchmark {

  /** Nobody comes far away, so that the flight can go on for ever. */
  private static final List<String> TOUR =
      List.of(
          "forward 50",
          "back 50",
          "cw 90",
          "left 30",
          "right 30",
          "ccw 90",
          "up 40",
          "rc 0 0 0 30",
          "down 40",
          "rc 0 0 0 0");

  private static final Room HALL = new Room(20, 20, 5);
  private static final int ROW = 10;
  private static final double APART = 1.5;
  private static final int TURNS = 15;
  private static final int STEPS_OF_TURN = 200_000;
  private static final int STEPS_AT_ONCE = 200;
  private static final double HOUR = 3600;
  private static final int MANY = 100;
  private static final double MANY_SECONDS = 300;
  private static final double MANY_FACTOR = 50;

  private RecordingBenchmark() {}

  /** Drones that fly without end, with somebody who listens or not. */
  private static final class Flight implements AutoCloseable {

    private final Path folder;
    private final Optional<FlightRecorder> recorder;
    private final List<Phrase> told = new ArrayList<>();
    private final Simulation simulation;
    private final Optional<DatagramPort> port;
    private final int[] next;
    private final InetSocketAddress address =
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 8879);
    private final InetSocketAddress operator =
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 9);

    Flight(int drones, boolean recorded, Optional<DatagramPort> port) throws IOException {
      this.port = port;
      folder = Files.createTempDirectory("recordings");
      next = new int[drones];
      List<Pose> starts =
          IntStream.range(0, drones)
              .mapToObj(i -> new Vec3(i / ROW - ROW / 2, i % ROW - ROW / 2, 0).times(APART))
              .map(place -> new Pose(place, Attitude.LEVEL))
              .toList();
      SimConfig config = SimConfig.DEFAULT.withRoom(HALL, starts);
      Scenario scenario = Scenario.of(config);
      GoalWatch goals = new GoalWatch(Challenge.NONE, news -> {});
      recorder =
          recorded
              ? Optional.of(
                  FlightRecorder.start(
                      RecordingFolder.at(folder),
                      new FlightRecorder.Subject("", scenario, List.of(), goals),
                      told::add))
              : Optional.empty();
      simulation =
          new Simulation(config, drone -> datagram -> sent(drone, datagram), List.of(goals));
      recorder.ifPresent(each -> each.follow(simulation::time, simulation::snapshot));
      recorder.ifPresent(simulation::listen);
      for (int drone = 1; drone <= drones; drone++) {
        simulation.control(new Control.Power(drone, true));
        submit(drone, "command");
      }
      for (int i = 0; i < STEPS_AT_ONCE; i++) {
        simulation.step();
      }
      for (int drone = 1; drone <= drones; drone++) {
        submit(drone, "takeoff");
      }
    }

    /** Sends state lines to sockets that no one reads, and drops the rest. */
    private void sent(int drone, LinkDatagram datagram) {
      if (datagram.direction() == LinkDirection.STATE) {
        new DatagramSender(new Ports(List.of(new Sink(drone))), OptionalInt.empty()).send(datagram);
      } else {
        replied(drone);
      }
    }

    /** The next command follows the reply to the one before; the first one that to takeoff. */
    private void replied(int drone) {
      if (simulation != null
          && simulation.snapshot().drones().get(drone - 1).state().phase().flying()) {
        fly(drone);
      }
    }

    private void fly(int drone) {
      String command = TOUR.get(next[drone - 1]++ % TOUR.size());
      if (command.equals(TOUR.get(0))) {
        simulation.control(new Control.SetBattery(drone, 100));
      }
      submit(drone, command);
      if (command.startsWith("rc ")) {
        fly(drone);
      }
    }

    private void submit(int drone, String command) {
      Peer peer = new Peer(operator, address);
      byte[] bytes = WireText.encode(command);
      SimInput datagram = new SimInput.Datagram(drone, peer, bytes);
      recorder.ifPresent(each -> each.onInput(simulation.time(), datagram));
      simulation.submit(drone, peer, bytes);
    }

    double seconds() {
      return simulation.snapshot().time().seconds();
    }

    void step(int steps) {
      for (int i = 0; i < steps; i++) {
        simulation.step();
      }
    }

    /** Ends it; the folder of its recording. */
    Path ended() throws IOException {
      recorder.ifPresent(FlightRecorder::close);
      if (!told.isEmpty()) {
        throw new IllegalStateException(told.toString());
      }
      try (Stream<Path> folders = Files.list(folder)) {
        List<Path> all = folders.toList();
        if (all.size() != 1) {
          throw new IllegalStateException("there are " + all);
        }
        return all.get(0);
      }
    }

    @Override
    public void close() throws IOException {
      recorder.ifPresent(FlightRecorder::close);
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(path);
        }
      }
    }

    /** Takes state lines. */
    private final class Sink implements DatagramPort {
      private final int drone;

      Sink(int drone) {
        this.drone = drone;
      }

      @Override
      public InetSocketAddress address() {
        return address;
      }

      @Override
      public void send(byte[] bytes, InetSocketAddress to) {
        recorder.ifPresent(each -> each.sent(drone, WireTap.Kind.STATE, address, to, bytes));
        port.ifPresent(each -> each.send(bytes, to));
      }

      @Override
      public void close() {}
    }
  }

  static List<Measurement> all() throws IOException {
    List<Measurement> rows = new ArrayList<>();
    try (DatagramPort port =
        UdpPort.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
      Cost sent = cost(Optional.of(port));
      rows.add(
          Measurement.atMost(
              "Recording one drone as fast as possible, of the simulation thread's time, median of "
                  + TURNS,
              3,
              sent.percent,
              "%"));
      rows.add(Measurement.beside("… and besides", sent.besides));
    }
    Cost dropped = cost(Optional.empty());
    rows.add(
        Measurement.beside(
            "… where state lines are dropped rather than sent",
            String.format(Locale.ROOT, "%.1f %%, %s", dropped.percent, dropped.besides)));
    rows.add(many());
    rows.add(hour());
    return rows;
  }

  /**
   * What a recorder costs.
   *
   * @param percent of the simulation thread's processor time
   */
  private record Cost(double percent, String besides) {}

  /**
   * In turns, so that a busy machine slows both down.
   *
   * @param port through which state lines are sent; empty if they are dropped
   */
  private static Cost cost(Optional<DatagramPort> port) throws IOException {
    List<Double> processor = new ArrayList<>();
    List<Double> wall = new ArrayList<>();
    List<Double> factors = new ArrayList<>();
    double recordedMs = 0;
    double writerMs = 0;
    try (Flight plain = new Flight(1, false, port);
        Flight recorded = new Flight(1, true, port)) {
      plain.step(STEPS_OF_TURN);
      recorded.step(STEPS_OF_TURN);
      double begun = writerMs();
      for (int turn = 0; turn < TURNS; turn++) {
        Turn without = Turn.of(() -> plain.step(STEPS_OF_TURN));
        Turn with = Turn.of(() -> recorded.step(STEPS_OF_TURN));
        recordedMs += with.processorMs;
        processor.add(100 * (with.processorMs / without.processorMs - 1));
        wall.add(100 * (with.wallMs / without.wallMs - 1));
        factors.add(STEPS_OF_TURN * SimTime.STEP / without.wallMs * 1000);
      }
      writerMs = writerMs() - begun;
    }
    double writing = 100 * writerMs / recordedMs;
    return new Cost(
        new Statistics(processor).median(),
        String.format(
            Locale.ROOT,
            "%.1f %% by the wall clock at %.0f ×; the thread that writes takes %.0f %% of the"
                + " simulation's time",
            new Statistics(wall).median(),
            new Statistics(factors).median(),
            writing));
  }

  /** Processor time of the thread that writes, until now [ms]. */
  private static double writerMs() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    for (ThreadInfo thread : threads.getThreadInfo(threads.getAllThreadIds())) {
      if (thread != null && thread.getThreadName().equals("recorder")) {
        return threads.getThreadCpuTime(thread.getThreadId()) * 1e-6;
      }
    }
    throw new IllegalStateException("nobody records");
  }

  private record Turn(double processorMs, double wallMs) {
    static Turn of(Runnable task) {
      long begun = System.nanoTime();
      double processorMs = Stopwatch.ms(task);
      return new Turn(processorMs, (System.nanoTime() - begun) * 1e-6);
    }
  }

  /** A hundred drones at fifty times real time: each row and each state line must be there. */
  private static Measurement many() throws IOException {
    try (Flight flight = new Flight(MANY, true, Optional.empty())) {
      long begun = System.nanoTime();
      double start = flight.seconds();
      while (flight.seconds() - start < MANY_SECONDS) {
        flight.step(STEPS_AT_ONCE);
        double ahead =
            (flight.seconds() - start) / MANY_FACTOR - (System.nanoTime() - begun) * 1e-9;
        if (ahead > 0) {
          LockSupport.parkNanos((long) (ahead * 1e9));
        }
      }
      double factor = (flight.seconds() - start) / (System.nanoTime() - begun) * 1e9;
      Path folder = flight.ended();
      double flown = seconds(folder);
      long rows = count(folder.resolve("flight.csv")) - 1;
      long expected = MANY * (Math.round(flown * 20) + 1);
      long lines = count(folder.resolve("wire.jsonl"));
      boolean all = rows == expected && lines >= MANY * Math.round((flown - 1) * 10);
      return new Measurement(
          "… "
              + MANY
              + " drones at "
              + (int) MANY_FACTOR
              + " ×, rows and datagrams that are missing",
          "none",
          String.format(Locale.ROOT, "%d of %d rows, at %.0f ×", expected - rows, expected, factor),
          all);
    }
  }

  /** From the first row to the last one [s]. */
  private static double seconds(Path folder) throws IOException {
    List<String> rows = Files.readAllLines(folder.resolve("flight.csv"));
    return moment(rows.get(rows.size() - 1)) - moment(rows.get(1));
  }

  private static double moment(String row) {
    return Double.parseDouble(row.substring(0, row.indexOf(',')));
  }

  private static long count(Path file) throws IOException {
    try (Stream<String> lines = Files.lines(file)) {
      return lines.count();
    }
  }

  private static Measurement hour() throws IOException {
    try (Flight flight = new Flight(1, true, Optional.empty())) {
      double start = flight.seconds();
      while (flight.seconds() - start < HOUR) {
        flight.step(STEPS_AT_ONCE);
      }
      Path folder = flight.ended();
      double bytes;
      try (Stream<Path> files = Files.list(folder)) {
        bytes = files.mapToDouble(RecordingBenchmark::size).sum();
      }
      return Measurement.atMost("… an hour of one drone, without film", 60, bytes / 1e6, "MB");
    }
  }

  private static double size(Path file) {
    try {
      return Files.size(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
