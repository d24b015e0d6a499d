package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.network.AddressPlan;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.HeadlessSimulators;
import tellosimulator.time.TimeFactor;

/** Records a drone that streams video, with real sockets. */
@Timeout(value = 180, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RecordedFilmTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final int LONGEST = 2048;
  private static final int PATIENCE_MS = 60_000;

  /** Number of video datagrams that are compared. */
  private static final int COUNT = 200;

  @TempDir private Path folder;

  @Test
  void filmAndItsDatagramsAreRecordedOnceADroneFlies() throws Exception {
    try (DatagramSocket video = socket();
        DatagramSocket commands = socket()) {
      List<String> seen = new ArrayList<>();
      try (HeadlessSimulator simulator = simulator(video.getLocalPort())) {
        simulator.record(RecordingFolder.at(folder), List.of());
        simulator.switchOn();
        InetSocketAddress drone = address(simulator);
        assertThat(ask(commands, "command", drone)).isEqualTo("ok");
        assertThat(ask(commands, "streamon", drone)).isEqualTo("ok");
        assertThat(ask(commands, "takeoff", drone)).isEqualTo("ok");
        for (int i = 0; i < COUNT; i++) {
          seen.add(digest(receive(video)));
        }
        assertThat(ask(commands, "land", drone)).isEqualTo("ok");
      }

      RecordingFiles files = RecordingFiles.only(folder);
      List<Map<String, Object>> sent = files.wire("video");
      assertThat(sent).extracting(datagram -> datagram.get("sha256")).containsAll(recent(seen));
      assertThat(sent)
          .allSatisfy(
              datagram ->
                  assertThat(datagram)
                      .containsEntry("to", "127.0.0.1:" + video.getLocalPort())
                      .containsKey("size"));
      assertThat(Files.size(files.folder().resolve("video-1.mp4"))).isGreaterThan(10_000);
      assertThat((List<?>) files.run().get("videos"))
          .singleElement()
          .asString()
          .contains("file=video-1.mp4");
    }
  }

  /** Returns the datagrams that were certainly received after the takeoff. */
  private static List<String> recent(List<String> seen) {
    return seen.subList(seen.size() - 10, seen.size());
  }

  /**
   * Runs as fast as possible: time stands still while the test waits for video, so the drone stays
   * up.
   */
  private static HeadlessSimulator simulator(int videoPort) throws Exception {
    SimConfig config =
        SimConfig.DEFAULT
            .withStreamPorts(new StreamPorts(9, videoPort))
            .withTimeFactor(TimeFactor.MAX);
    return HeadlessSimulators.of(Scenario.of(config), AddressPlan.of(List.of(LOOPBACK), 0));
  }

  /** Returns the drone's address from the ready line. */
  private static InetSocketAddress address(HeadlessSimulator simulator) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    simulator.sayReady(new PrintStream(out, true, StandardCharsets.UTF_8));
    String line = out.toString(StandardCharsets.UTF_8).strip();
    return new InetSocketAddress(LOOPBACK, Integer.parseInt(line.replaceAll(".*:", "")));
  }

  private static DatagramSocket socket() throws IOException {
    DatagramSocket socket = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
    socket.setSoTimeout(PATIENCE_MS);
    return socket;
  }

  private static byte[] receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[LONGEST], LONGEST);
    socket.receive(packet);
    return Arrays.copyOf(packet.getData(), packet.getLength());
  }

  private static String ask(DatagramSocket socket, String text, InetSocketAddress drone)
      throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length, drone));
    return new String(receive(socket), StandardCharsets.US_ASCII);
  }

  private static String digest(byte[] bytes) throws NoSuchAlgorithmException {
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(bytes);
    return HexFormat.of().formatHex(digest).substring(0, 16);
  }
}
