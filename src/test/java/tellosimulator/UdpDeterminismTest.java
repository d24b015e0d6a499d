package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Checks that with time factor {@code max}, a program that sends each command after the reply to
 * the previous one receives identical replies and state lines in each run, to the byte: over real
 * sockets, from a separate process, however long the program thinks, and however busy the machine
 * is.
 */
@Tag("process")
@Timeout(value = 300, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@Tag("slow")
class UdpDeterminismTest {

  private static final int DRONES = 3;

  /** Threads that only keep the processors busy. */
  private static final int LOAD = 2;

  private static final int RUNS = 2;

  /** The longest time that a program thinks between two commands [ms]. */
  private static final int LONGEST_PAUSE_MS = 12;

  private static final String SCENARIO =
      """
      room: {width: 900, depth: 900, height: 400}
      pads:
        - {id: 1, at: [0, 0], heading: 0}
        - {id: 2, at: [150, 0], heading: 0}
      drones:
        - start: [0, 0]
        - start: [0, 200]
        - start: [0, -200]
      """;

  /**
   * Faults that deliver each reply once, because the script waits for it, and also the last state
   * line.
   */
  private static final String FAULTS =
      """
      faults:
        - delay commands 20ms spread 30ms
        - delay replies 30ms spread 40ms
        - delay state 40ms spread 30ms
        - loss state 20% burst 2 drone 1
        - duplicate state 10%
        - reorder state 10% drone 2 at 3s
        - corrupt state 5% drone 1 for 10s
        - dark drone 2 after "curve" for 2s
      """;

  private static final String FAULTY = "measured --link ideal --seed 3";

  /** Drone and command. The last one is visible in the last state line. */
  private static final String SCRIPT =
      """
      1 command
      1 battery?
      2 command
      3 command
      1 mon
      1 takeoff
      1 tof?
      2 speed 30
      2 takeoff
      1 mdirection 2
      2 rc 0 30 0 0
      1 baro?
      2 rc 0 0 0 40
      1 height?
      3 takeoff
      1 rc 10 0 0 0
      3 attitude?
      1 rc 0 0 0 0
      2 attitude?
      3 rc 0 0 20 0
      1 cw 90
      3 rc 0 0 0 0
      3 height?
      2 rc 0 -20 0 0
      3 battery?
      2 rc 0 0 0 0
      1 tof?
      2 stop
      2 time?
      1 go 100 0 60 60 m1
      1 stop
      1 acceleration?
      3 emergency
      2 height?
      3 takeoff
      1 speed?
      1 forward 50
      1 tof?
      2 curve 25 -25 0 25 -75 0 40
      2 battery?
      3 rc 20 20 0 0
      1 battery?
      3 rc 0 0 0 0
      2 stop
      3 stop
      1 rc 0 0 0 30
      1 rc 0 0 0 0
      1 jump 100 0 80 50 0 m1 m2
      2 flip l
      2 temp?
      1 land
      2 rc 0 20 10 0
      2 rc 0 0 0 0
      2 foo
      2 land
      3 tof?
      3 land
      1 battery?
      3 mon
      """;

  private static final Pattern PORT = Pattern.compile("drone \\d+ at [0-9.]+:(\\d+)");

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "report",
        "measured --link ideal",
        "report --fault delay", // all directions, 0.1 s
        FAULTY
      })
  void aProgramThatWaitsForEachReplyGetsTheSameBytesInEachRun(String behavior) throws Exception {
    List<String> expected = fly(SCRIPT, behavior, new Random(0), 0);
    assertThat(expected).hasSizeGreaterThan(200);

    try (Load load = new Load()) {
      assertThat(load.threads).hasSize(LOAD);
      for (int run = 1; run < RUNS; run++) {
        assertThat(fly(SCRIPT, behavior, new Random(run), LONGEST_PAUSE_MS))
            .as("run %d", run)
            .isEqualTo(expected);
      }
    }
  }

  @Test
  void anotherSeedGivesOtherNoise() throws Exception {
    String script = "1 command\n1 takeoff\n3 command\n3 mon\n";

    assertThat(fly(script, "measured --link ideal --seed 8", new Random(0), 0))
        .isNotEqualTo(fly(script, "measured --link ideal", new Random(0), 0));
  }

  /** Returns all replies, and then all state lines, each with its drone. */
  private List<String> fly(String script, String behavior, Random pauses, int longestMs)
      throws IOException {
    String text = SCENARIO + (behavior.equals(FAULTY) ? FAULTS : "");
    Path scenario = Files.writeString(folder.resolve("pads.yaml"), text);
    try (StateLines states = new StateLines();
        ProgramProcess program =
            ProgramProcess.start(
                Main.class,
                "--headless --port-per-drone --time-factor max --log-level off --scenario "
                    + scenario
                    + " --state-port "
                    + states.socket.getLocalPort()
                    + " --behaviour "
                    + behavior,
                "");
        DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      socket.setSoTimeout(ProgramProcess.PATIENCE_SECONDS * 1000);
      List<Integer> ports = ports(program.line());
      List<String> received = new ArrayList<>();
      for (String line : script.lines().toList()) {
        if (longestMs > 0 && pauses.nextBoolean()) {
          LockSupport.parkNanos(pauses.nextInt(longestMs * 1_000_000));
        }
        int drone = Integer.parseInt(line.substring(0, 1));
        String command = line.substring(2);
        byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
        socket.send(
            new DatagramPacket(
                bytes, bytes.length, InetAddress.getLoopbackAddress(), ports.get(drone - 1)));
        if (!command.startsWith("rc ") && !command.equals("emergency")) {
          awaitReply(socket, ports, received);
        }
      }
      received.addAll(states.upToLineWith("mid:-1", ports.get(DRONES - 1), ports));
      return received;
    }
  }

  private static void awaitReply(DatagramSocket socket, List<Integer> ports, List<String> received)
      throws IOException {
    String reply;
    do {
      DatagramPacket packet = new DatagramPacket(new byte[1500], 1500);
      socket.receive(packet);
      reply = text(packet);
      received.add(ports.indexOf(packet.getPort()) + 1 + " " + reply);
    } while (reply.equals("forced stop")); // which the script does not wait for
  }

  private static List<Integer> ports(String ready) {
    List<Integer> ports =
        PORT.matcher(ready)
            .results()
            .map((MatchResult found) -> Integer.valueOf(found.group(1)))
            .toList();
    assertThat(ports).as(ready).hasSize(DRONES);
    return ports;
  }

  private static String text(DatagramPacket packet) {
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  /** Receives all state lines on a separate thread, so that none is lost. */
  private static final class StateLines implements AutoCloseable {

    private static final int BUFFER = 1 << 20;

    private record Line(int port, String text) {}

    private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    private final List<Line> lines = new CopyOnWriteArrayList<>();

    StateLines() throws IOException {
      socket.setReceiveBufferSize(BUFFER);
      Thread reader = new Thread(this::read, "state lines");
      reader.setDaemon(true);
      reader.start();
    }

    private void read() {
      try {
        while (!socket.isClosed()) {
          DatagramPacket packet = new DatagramPacket(new byte[1500], 1500);
          socket.receive(packet);
          synchronized (lines) {
            lines.add(new Line(packet.getPort(), text(packet)));
            lines.notifyAll();
          }
        }
      } catch (IOException e) {
        assertThat(socket.isClosed()).isTrue();
      }
    }

    /** Waits for the first line of a drone that contains a text; returns all lines up to it. */
    List<String> upToLineWith(String text, int port, List<Integer> ports) {
      synchronized (lines) {
        int end = lastIndex(text, port);
        while (end < 0) {
          try {
            lines.wait();
          } catch (InterruptedException e) {
            throw new AssertionError("the last state line does not come", e);
          }
          end = lastIndex(text, port);
        }
        return lines.subList(0, end + 1).stream()
            .map(line -> ports.indexOf(line.port) + 1 + " " + line.text)
            .toList();
      }
    }

    private int lastIndex(String text, int port) {
      for (int i = 0; i < lines.size(); i++) {
        if (lines.get(i).port == port && lines.get(i).text.contains(text)) {
          return i;
        }
      }
      return -1;
    }

    @Override
    public void close() {
      socket.close();
    }
  }

  /** Keeps the processors busy. */
  private static final class Load implements AutoCloseable {

    private final List<Thread> threads = new ArrayList<>();
    private volatile boolean ended;

    Load() {
      for (int i = 0; i < LOAD; i++) {
        Thread thread = new Thread(this::run, "load");
        thread.setDaemon(true);
        thread.start();
        threads.add(thread);
      }
    }

    private void run() {
      while (!ended) {
        Thread.onSpinWait();
      }
    }

    @Override
    public void close() {
      ended = true;
    }
  }
}
