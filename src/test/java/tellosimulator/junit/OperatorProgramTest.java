package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.junit.TelloAssertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The programs are Java sources, because every machine that builds the project can run Java. */
@Tag("process")
@TelloTest
class OperatorProgramTest {

  private static final String JAVA =
      Path.of(System.getProperty("java.home"), "bin", "java").toString();

  private static final String FLIGHT =
      """
      import java.net.*;
      class Flight {
        public static void main(String[] arguments) throws Exception {
          try (DatagramSocket socket = new DatagramSocket()) {
            for (String command : new String[] {"command", "takeoff", "land"}) {
              byte[] bytes = command.getBytes();
              socket.send(new DatagramPacket(bytes, bytes.length,
                  new InetSocketAddress(arguments[0], Integer.parseInt(arguments[1]))));
              DatagramPacket reply = new DatagramPacket(new byte[100], 100);
              socket.receive(reply);
              System.out.println(command + ": " + new String(reply.getData(), 0, reply.getLength()));
            }
          }
          System.exit(Integer.parseInt(arguments[2]));
        }
      }
      """;

  @TempDir private Path folder;

  @Test
  void aProgramOfAnyLanguageFliesAndItsOutputIsKept(SimulatedDrone drone) throws IOException {
    OperatorProgram program = flight(drone, "0").run();

    assertThat(program.output().lines()).containsSequence("command: ok", "takeoff: ok", "land: ok");
    assertThat(drone).hasLanded();
  }

  @Test
  void anExitCodeThatIsNotZeroFailsWithTheOutput(SimulatedDrone drone) throws IOException {
    OperatorProgram program = flight(drone, "3");

    assertThatThrownBy(program::run)
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("for drone 1 ended with exit code 3" + System.lineSeparator())
        .hasMessageContaining("land: ok");
    assertThat(flight(drone, "3").exitCode()).isEqualTo(3);
  }

  @Test
  void aProgramThatHangsIsKilled(SimulatedDrone drone) throws IOException {
    Path source =
        Files.writeString(
            folder.resolve("Hang.java"),
            """
            class Hang {
              public static void main(String[] arguments) throws Exception {
                System.in.transferTo(System.out);
                Thread.sleep(Long.MAX_VALUE);
              }
            }
            """);
    OperatorProgram program = drone.program(JAVA, source.toString()).within(Duration.ofSeconds(2));

    assertThatThrownBy(program::run)
        .isInstanceOf(AssertionError.class)
        .hasMessageEndingWith("for drone 1 was killed, because it ran longer than 2.0 s");
    assertThat(
            ProcessHandle.current().descendants().map(one -> one.info().commandLine().orElse("")))
        .noneMatch(line -> line.contains("Hang.java"));
  }

  @Test
  void whatCannotBeMeantIsRefusedBeforeItIsRun(SimulatedDrone drone) {
    assertThatThrownBy(() -> drone.program("fly", "{comandPort}"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no placeholder {comandPort}, did you mean {commandPort}?");
    OperatorProgram program = drone.program(JAVA, "--version");
    assertThatThrownBy(() -> program.in(folder.resolve("nope")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no folder " + folder.resolve("nope") + " to run the program in");
    program.run();
  }

  @Test
  void aProgramThatIsNotThereIsNamed(SimulatedDrone drone) {
    assertThatThrownBy(() -> drone.program("no-such-program", "{host}:{commandPort}").run())
        .isInstanceOf(AssertionError.class)
        .hasMessageStartingWith(
            "no-such-program 127.0.0.1:" + drone.commandPort() + " for drone 1 could not be run: ");
  }

  private OperatorProgram flight(SimulatedDrone drone, String exit) throws IOException {
    Path source = Files.writeString(folder.resolve("Flight.java"), FLIGHT);
    List<String> command =
        List.of(
            JAVA, "-XX:TieredStopAtLevel=1", source.toString(), "{host}", "{commandPort}", exit);
    return drone.program(command.toArray(new String[0]));
  }
}
