package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

class MainTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final int PATIENCE_SECONDS = 30;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @ParameterizedTest
  @ValueSource(strings = {"--help", "-h", "--help --profile edu"})
  void helpNamesEveryOptionForATerminalOfAnyKind(String line) {
    assertThat(run(line)).isZero();

    assertThat(lines(out)).startsWith("Simulates Tello drones").isASCII();
    List<String> options =
        CommandSpec.forAnnotatedObject(new Options()).options().stream()
            .map(OptionSpec::longestName)
            .toList();
    assertThat(options).hasSize(15);
    assertThat(lines(out)).contains(options).contains("--help", "--version");
    assertThat(lines(out).lines()).allMatch(printed -> printed.length() <= 80);
    assertThat(lines(err)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"--version", "-V"})
  void versionIsOneLine(String line) {
    assertThat(run(line)).isZero();

    assertThat(lines(out)).matches("Tello Simulator \\S+\n");
    assertThat(lines(err)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --fly             | There is no option --fly. Try --help.
          fly               | There is no option fly. Try --help.
          --drones          | Missing required parameter for option '--drones' (N). Try --help.
          --drones 0        | Invalid value for option '--drones': expected a number from 1 to 250, found 0. Try --help.
          --profile=        | Invalid value for option '--profile': expected one of edu, tello, tt, found nothing. Try --help.
          --drones 1 --drones 2 | Option '--drones' (N) should be specified only once. Try --help.
          --start 9999,0    | Drone 1 does not fit into the room: its start would be at x 9999, y 0 cm. Try --help.
          """)
  void wrongOptionsAreOneSentenceAndExitCodeTwo(String line, String sentence) {
    assertThat(run(line)).isEqualTo(2);

    assertThat(lines(err)).isEqualTo(sentence + "\n");
    assertThat(lines(out)).isEmpty();
  }

  @Test
  void aPortThatIsTakenIsOneSentenceAndExitCodeOne() throws IOException {
    try (DatagramSocket other = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      int port = other.getLocalPort();

      assertThat(run("--headless --bind 127.0.0.1 --command-port " + port)).isEqualTo(1);

      assertThat(lines(err))
          .isEqualTo(
              "Port %d of 127.0.0.1 is taken, probably by a Tello simulator that is still running: "
                      .formatted(port)
                  + "end that program, or choose another port with --command-port.\n");
      assertThat(lines(out)).isEmpty();
    }
  }

  @Test
  void anAddressOfAnotherMachineIsOneSentenceAndExitCodeOne() {
    assertThat(run("--headless --bind 192.0.2.77 --command-port 0")).isEqualTo(1);

    assertThat(lines(err))
        .isEqualTo(
            "This machine has no address 192.0.2.77: "
                + "choose one of this machine's own addresses with --bind.\n");
  }

  @Test
  @Timeout(2 * PATIENCE_SECONDS)
  void quitEndsTheProgram() throws Exception {
    Process process = start("--headless --bind 127.0.0.1 --command-port 0");
    try (BufferedReader printed = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(printed.readLine()).matches("ready: drone 1 at 127\\.0\\.0\\.1:[0-9]+");
      process.outputWriter(StandardCharsets.UTF_8).append("quit\n").close();

      assertThat(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
      assertThat(process.exitValue()).isZero();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  @Timeout(2 * PATIENCE_SECONDS)
  void theEndOfInputChangesNothingAndATerminationFreesThePort() throws Exception {
    Process process = start("--headless --bind 127.0.0.1 --command-port 0 --state-port 9");
    try (BufferedReader printed = process.inputReader(StandardCharsets.UTF_8)) {
      int port = Integer.parseInt(printed.readLine().replaceAll(".*:", ""));
      process.outputWriter(StandardCharsets.UTF_8).close();
      assertThat(ask("command", port)).isEqualTo("ok");

      process.destroy();

      assertThat(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
      assertThat(isFree(port)).isTrue();
    } finally {
      process.destroyForcibly();
    }
  }

  private int run(String line) {
    return Main.run(
        line.split(" ", -1),
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private static String lines(ByteArrayOutputStream printed) {
    return printed.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
  }

  private static Process start(String line) throws IOException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String classPath = System.getProperty("java.class.path");
    ProcessBuilder builder =
        new ProcessBuilder(java, "-cp", classPath, Main.class.getName())
            .redirectError(ProcessBuilder.Redirect.DISCARD);
    builder.command().addAll(List.of(line.split(" ", -1)));
    return builder.start();
  }

  private static String ask(String text, int port) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_SECONDS * 1000);
      byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
      DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }
  }

  private static boolean isFree(int port) {
    try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(LOOPBACK, port))) {
      return socket.isBound();
    } catch (SocketException e) {
      return false;
    }
  }
}
