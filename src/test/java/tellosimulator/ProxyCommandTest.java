package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFiles;

/** Tests the subcommand {@code proxy} on the command line. */
@Tag("process")
class ProxyCommandTest {

  @TempDir private Path folder;
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  /** A refused takeoff is recorded, too, so that users can see the reason. */
  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void whatPassesIsRecordedUntilQuit() throws Exception {
    try (DatagramSocket drone = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        ProgramProcess program = ProgramProcess.proxy(drone.getLocalPort(), folder)) {
      drone.setSoTimeout(ProgramProcess.PATIENCE_SECONDS * 1000);
      int port = program.port();
      assertThat(program.line())
          .startsWith("passing on: commands to 127.0.0.1:" + drone.getLocalPort())
          .contains("its state to port 8890");
      takeOff(port, drone);
      program.type("quit\n");

      assertThat(program.line()).startsWith("recorded: " + folder);
      assertThat(program.exitCode()).isZero();
    }

    RecordedFlight flight = RecordedFlight.read(RecordingFiles.only(folder).folder());
    assertThat(flight.commands())
        .singleElement()
        .satisfies(command -> assertThat(command.reply()).isEqualTo("error No valid imu"));
    assertThat(flight.run().setting().options()).startsWith("proxy").contains("--drone");
    String recording = RecordingFiles.only(folder).folder().toString();
    assertThat(run("report", recording)).isZero();
    assertThat(run("diff", recording, recording)).isZero();
    assertThat(run("export", recording, "--to", "mcap")).isZero();
    assertThat(run("export", recording, "--to", "pcap")).isZero();
    assertThat(err.size()).isZero();
  }

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void whoTerminatesItIsToldWhereTheFlightsAre() throws Exception {
    try (DatagramSocket drone = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        ProgramProcess program = ProgramProcess.proxy(drone.getLocalPort(), folder)) {
      drone.setSoTimeout(ProgramProcess.PATIENCE_SECONDS * 1000);
      int port = program.port();
      assertThat(program.line()).startsWith("passing on: ");
      takeOff(port, drone);

      program.terminate();

      assertThat(program.line()).startsWith("recorded: " + folder);
      assertThat(program.exitCode()).isEqualTo(143);
    }
  }

  @Test
  void aStatePortThatIsTakenIsASentence() throws IOException {
    try (DatagramSocket other = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      String taken = Integer.toString(other.getLocalPort());
      String line = "proxy --drone 127.0.0.1 --command-port 0 --drone-state-port " + taken;

      assertThat(run((line + " --record " + folder).split(" ", -1))).isEqualTo(1);

      assertThat(err.toString(StandardCharsets.UTF_8).lines())
          .singleElement()
          .asString()
          .startsWith("Port " + taken + " of 127.0.0.1 is not available")
          .contains("the drone sends its state there")
          .contains("--state-port");
    }
  }

  /** Sends a takeoff from a program; the drone refuses it. */
  private static void takeOff(int port, DatagramSocket drone) throws IOException {
    try (DatagramSocket operator = new DatagramSocket()) {
      byte[] takeoff = "takeoff".getBytes(StandardCharsets.US_ASCII);
      operator.send(
          new DatagramPacket(takeoff, takeoff.length, InetAddress.getLoopbackAddress(), port));
      answer(drone, "error No valid imu");
      operator.setSoTimeout(ProgramProcess.PATIENCE_SECONDS * 1000);
      operator.receive(new DatagramPacket(new byte[100], 100));
    }
  }

  private static void answer(DatagramSocket drone, String reply) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[100], 100);
    drone.receive(packet);
    packet.setData(reply.getBytes(StandardCharsets.US_ASCII));
    drone.send(packet);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          proxy                           | Missing required option: '--drone=ADDRESS[:PORT]'. Try --help.
          proxy --drone drone             | Invalid value for option '--drone': expected the address of a drone such as 192.168.10.1 or 192.168.10.1:8889, found drone. Try --help.
          proxy --drone 192.168.10.1:0    | Invalid value for option '--drone': expected the address of a drone such as 192.168.10.1 or 192.168.10.1:8889, found 0. Try --help.
          proxy --drone 127.0.0.1 --record pom.xml | --record pom.xml: no flight can be recorded there: pom.xml is in the way. Try --help.
          proxy --drone 127.0.0.1:8879 --record target/proxy | --drone 127.0.0.1:8879 is where the proxy itself takes commands; name the drone's address. Try --help.
          """)
  void mistakesAreSentences(String words, String sentence) {
    assertThat(run(words.split(" ", -1))).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualToIgnoringNewLines(sentence);
  }
}
