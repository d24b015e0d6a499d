package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.locks.LockSupport;
import tellosimulator.benchmark.Measurement;

/**
 * Programs that send each command after the reply to the one before, twice each, while others keep
 * the machine busy. Each run is a process of its own.
 */
final class DeterminismTrial {

  private static final int DRONES = 3;
  private static final int BUSY_THREADS = 4;
  private static final double SHORTEST_SECONDS = 15;
  private static final double SECONDS_A_MINUTE = 5;
  private static final int COMMANDS = 40;
  private static final int LONGEST_PAUSE_NANOS = 12_000_000;

  /** After so long a silence no state line is owed any more [ms]. */
  private static final int SILENCE_MS = 1000;

  private static final int REPLY_MS = 60_000;

  /** What {@code stop} makes a drone send beside its reply. */
  private static final String UNASKED = "forced stop";

  private static final String SCENARIO =
      """
      room: {width: 900, depth: 900, height: 400}
      pads:
        - {id: 1, at: [0, 0], heading: 0}
        - {id: 2, at: [150, 0], heading: 0}
      drones:
        - {start: [0, 0], behaviour: measured}
        - {start: [0, 200]}
        - {start: [0, -200], behaviour: measured}
      """;

  private static final List<String> WORDS =
      List.of(
          "battery?",
          "tof?",
          "baro?",
          "height?",
          "time?",
          "speed?",
          "attitude?",
          "temp?",
          "acceleration?",
          "mon",
          "moff",
          "mdirection 2",
          "speed 40",
          "takeoff",
          "takeoff",
          "land",
          "rc 0 0 0 40",
          "rc 10 -10 5 0",
          "rc 0 0 0 0",
          "stop",
          "up 30",
          "down 20",
          "forward 40",
          "back 40",
          "left 30",
          "cw 90",
          "ccw 45",
          "flip l",
          "go 40 0 20 50",
          "go 0 0 80 50 m1",
          "curve 25 -25 0 25 -75 0 40",
          "foward 50",
          "emergency");

  private DeterminismTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    double seconds = Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE);
    long end = System.nanoTime() + (long) (seconds * 1e9);
    int programs = 0;
    int same = 0;
    try (Load load = new Load()) {
      load.begin();
      for (int seed = 1; programs == 0 || System.nanoTime() < end; seed++) {
        List<String> first = fly(seed, new Random(1));
        List<String> second = fly(seed, new Random(2));
        programs++;
        same += first.equals(second) ? 1 : 0;
        tellDifference(seed, first, second);
      }
    }
    return List.of(
        new Measurement(
            "Programs over UDP that get the same bytes twice under load",
            "all of " + programs,
            same + " of " + programs,
            same == programs));
  }

  private static void tellDifference(int seed, List<String> first, List<String> second) {
    for (int i = 0; i < Math.min(first.size(), second.size()); i++) {
      if (!first.get(i).equals(second.get(i))) {
        System.out.printf("program %d, line %d:%n%s%n%s%n", seed, i, first.get(i), second.get(i));
        return;
      }
    }
    if (first.size() != second.size()) {
      System.out.printf("program %d: %d and %d lines%n", seed, first.size(), second.size());
    }
  }

  /** All replies and then all state lines, each with its drone. */
  private static List<String> fly(int seed, Random pauses) throws IOException {
    Path scenario = Files.writeString(Files.createTempFile("swarm", ".yaml"), SCENARIO);
    try (DatagramSocket states = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        SimulatorProcess simulator =
            SimulatorProcess.here(
                "--port-per-drone",
                "--bind",
                "127.0.0.1",
                "--command-port",
                "0",
                "--time-factor",
                "max",
                "--link",
                "ideal",
                "--seed",
                "7",
                "--scenario",
                scenario.toString(),
                "--state-port",
                "" + states.getLocalPort())) {
      socket.setSoTimeout(REPLY_MS);
      List<Integer> ports = new ArrayList<>();
      for (int drone = 1; drone <= DRONES; drone++) {
        ports.add(simulator.drone(drone).getPort());
      }
      CompletableFuture<Void> over = new CompletableFuture<>();
      CompletableFuture<List<String>> lines =
          CompletableFuture.supplyAsync(() -> statesUntilSilence(states, ports, over));
      List<String> received = new ArrayList<>();
      for (String line : script(seed)) {
        if (pauses.nextBoolean()) {
          LockSupport.parkNanos(pauses.nextInt(LONGEST_PAUSE_NANOS));
        }
        int drone = Integer.parseInt(line.substring(0, 1));
        String command = line.substring(2);
        send(socket, command, ports.get(drone - 1));
        if (!command.startsWith("rc ") && !command.equals("emergency")) {
          received.add(line + ": " + reply(socket, ports));
        }
      }
      over.complete(null);
      received.addAll(lines.join());
      return received;
    }
  }

  private static List<String> script(int seed) {
    Random random = new Random(seed);
    List<String> script = new ArrayList<>(List.of("1 command", "2 command", "3 command"));
    for (int i = 0; i < COMMANDS; i++) {
      script.add(1 + random.nextInt(DRONES) + " " + WORDS.get(random.nextInt(WORDS.size())));
    }
    for (int drone = 1; drone <= DRONES; drone++) { // or motion would go on after the program
      script.add(drone + " rc 0 0 0 0");
      script.add(drone + " battery?");
    }
    return script;
  }

  private static void send(DatagramSocket socket, String text, int port) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    socket.send(
        new DatagramPacket(
            bytes, bytes.length, new InetSocketAddress(InetAddress.getLoopbackAddress(), port)));
  }

  /** The next reply, and before it those that nobody waits for. */
  private static String reply(DatagramSocket socket, List<Integer> ports) throws IOException {
    String replies = receive(socket, ports);
    while (replies.endsWith(UNASKED)) {
      replies += ", " + receive(socket, ports);
    }
    return replies;
  }

  private static String receive(DatagramSocket socket, List<Integer> ports) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    socket.receive(packet);
    String text = new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
    return ports.indexOf(packet.getPort()) + 1 + " " + text.strip();
  }

  /** Takes state lines until none has come for a while; the system keeps few that wait. */
  private static List<String> statesUntilSilence(
      DatagramSocket states, List<Integer> ports, CompletableFuture<Void> over) {
    List<String> lines = new ArrayList<>();
    try {
      states.setSoTimeout(SILENCE_MS);
      while (true) {
        try {
          lines.add(receive(states, ports));
        } catch (SocketTimeoutException e) {
          if (over.isDone()) {
            return lines;
          }
        }
      }
    } catch (IOException e) {
      throw new CompletionException(e);
    }
  }

  /** Threads that keep the processors busy. */
  private static final class Load implements AutoCloseable {

    private volatile boolean over;

    void begin() {
      for (int i = 0; i < BUSY_THREADS; i++) {
        Daemon.start("busy", this::work);
      }
    }

    private void work() {
      while (!over) {
        Thread.onSpinWait();
      }
    }

    @Override
    public void close() {
      over = true;
    }
  }
}
