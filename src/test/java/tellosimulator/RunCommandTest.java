package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests the subcommand {@code run} on the command line. */
class RunCommandTest {

  /** Sleep time of a program that does not end by itself [s]. */
  private static final String NAP = "100000";

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(List<String> words) {
    return Main.run(
        Stream.concat(Stream.of("run"), words.stream()).toArray(String[]::new),
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --headless                         | Run needs your program after --, such as: run --headless -- python3 fly.py. Try --help.
          --headless --                      | Run needs your program after --, such as: run --headless -- python3 fly.py. Try --help.
          python3 fly.py                     | Run needs your program after --, such as: run --headless -- python3 fly.py. Try --help.
          --headles -- true                  | There is no option --headles. Try --help.
          --headless --bind 127.0.0.1 -- fly | --bind does not go with run, which decides that. Try --help.
          --headless --lan -- fly            | --lan does not go with run, which decides that. Try --help.
          --headless --room 9000x9000x300 --drones 241 -- fly | Run has addresses for 240 drones, but there are 241. Try --help.
          --drones 2 --report x -- fly       | --report needs --headless. Try --help.
          --headless --timeout 120 -- fly    | --timeout needs --headless and a --scenario with goals. Try --help.
          --program-output -- fly            | Expected parameter for option '--program-output' but found '--'. Try --help.
          """)
  void mistakesAreOneSentence(String line, String sentence) {
    assertThat(run(List.of(line.split(" ")))).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo(sentence + "\n");
    assertThat(out.size()).isZero();
  }

  /** Flies as with a real drone, which answers at 192.168.10.1, from port 8889 to port 8889. */
  static final class UnchangedProgram {

    /** A command for the program itself: to land when it is interrupted. */
    private static final String LAND_LATER = "land later";

    private UnchangedProgram() {}

    /**
     * Exits with code 0 if all commands are answered with {@code ok}.
     *
     * @param args the number of drones, their addresses, then the commands for each
     */
    public static void main(String[] args) throws IOException, InterruptedException {
      int drones = Integer.parseInt(args[0]);
      try (DatagramSocket socket = new DatagramSocket(8889)) {
        socket.setSoTimeout(1000 * ProgramProcess.PATIENCE_SECONDS);
        for (String command : List.of(args).subList(1 + drones, args.length)) {
          for (String drone : List.of(args).subList(1, 1 + drones)) {
            if (command.equals(LAND_LATER)) {
              landLater(socket, drone);
            }
            String reply = ask(socket, drone, command);
            if (!reply.equals("ok")) {
              System.exit(7);
            }
          }
        }
      }
    }

    private static void landLater(DatagramSocket socket, String drone) throws InterruptedException {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> land(socket, drone)));
      System.out.println("in the air");
      new CountDownLatch(1).await();
    }

    private static void land(DatagramSocket socket, String drone) {
      try {
        System.out.println("land: " + ask(socket, drone, "land"));
      } catch (IOException e) {
        System.out.println(e.getMessage());
      }
    }

    private static String ask(DatagramSocket socket, String drone, String command)
        throws IOException {
      byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, new InetSocketAddress(drone, 8889)));
      DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }
  }

  @Nested
  @NeedsTool({Tool.NAMESPACES, Tool.SH})
  @Tag("slow")
  @Timeout(ProgramProcess.PATIENCE_SECONDS)
  class InPrivateNetworks {

    private int fly(List<String> options, List<String> program) {
      List<String> words = new ArrayList<>(options);
      words.addAll(List.of("--headless", "--time-factor", "max", "--log-level", "error", "--"));
      words.addAll(program);
      return run(words);
    }

    private static List<String> unchanged(String... args) {
      return Jvm.commandOf(UnchangedProgram.class, args);
    }

    @Test
    void anUnchangedProgramFindsTheDroneWhereRealOnesAre() {
      assertThat(fly(List.of(), unchanged("1", "192.168.10.1", "command", "takeoff", "land")))
          .as(err.toString(StandardCharsets.UTF_8))
          .isZero();
      assertThat(out.toString(StandardCharsets.UTF_8))
          .isEqualTo("ready: drone 1 at 192.168.10.1:8889\nprogram: exit code 0\n");
    }

    @Test
    void aSwarmHasAddressesOfItsOwn() {
      assertThat(
              fly(
                  List.of("--drones", "3"),
                  unchanged("3", "192.168.10.11", "192.168.10.12", "192.168.10.13", "command")))
          .isZero();
    }

    @Test
    void theProgramsExitCodeCounts() {
      assertThat(fly(List.of(), List.of("sh", "-c", "exit 5"))).isEqualTo(5);
      assertThat(fly(List.of(), List.of("no-such-program"))).isEqualTo(127);
    }

    /** The run ends without waiting for the timeout of two simulated minutes or for any silence. */
    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        textBlock =
            """
            --scenario slalom                                | true   | 0 | 3
            --scenario slalom --timeout 120                  | exit 7 | 7 | 7
            --scenario slalom --exit-when-done --timeout 120 | fi     | 2 | 2
            """)
    void aProgramThatDiesAtOnceEndsTheFlight(
        String options, String script, int program, int status) {
      assertThat(fly(List.of(options.split(" ")), List.of("sh", "-c", script))).isEqualTo(status);
      assertThat(out.toString(StandardCharsets.UTF_8))
          .isEqualTo(
              """
              ready: drone 1 at 192.168.10.1:8889
              program: exit code %d
              goals: 0 of 4 reached after 0.0 s: the program has ended
              """,
              program);
    }

    @Test
    void aDroneThatIsLeftInTheAirLandsBeforeTheVerdict() {
      List<String> hovering = unchanged("1", "192.168.10.1", "command", "takeoff");

      assertThat(fly(List.of("--scenario", "slalom"), hovering)).isEqualTo(3);
      assertThat(out.toString(StandardCharsets.UTF_8))
          .containsPattern(
              "goals: 0 of 4 reached after [3-9]\\.. s: the program ended while drone 1 was in the"
                  + " air\n");
    }

    @Test
    void theLandingAtTheEndOfAProgramReachesNoGoal(@TempDir Path folder) throws IOException {
      Path scenario = folder.resolve("land.yaml");
      Files.writeString(scenario, "name: Land\ngoals:\n  - land: {at: [0, 0], radius: 50}\n");
      List<String> hovering = unchanged("1", "192.168.10.1", "command", "takeoff");

      assertThat(fly(List.of("--scenario", scenario.toString()), hovering)).isEqualTo(3);
      assertThat(out.toString(StandardCharsets.UTF_8)).contains("goals: 0 of 1 reached after");
    }

    @Test
    void aProgramThatIsStillInTheAirAfterTheVerdictIsEndedSoon() {
      List<String> words = shell("\"$@\" command takeoff 'forward 400'; exec sleep " + NAP);

      assertThat(fly(List.of("--scenario", "slalom", "--timeout", "30"), words)).isEqualTo(3);
      assertThat(out.toString(StandardCharsets.UTF_8)).contains("\nprogram: ended by run\n");
    }

    @Test
    void aProgramThatSleepsOnAfterTheVerdictIsEnded() {
      List<String> words = shell("\"$@\" command takeoff land; exec sleep " + NAP);

      assertThat(fly(List.of("--scenario", "slalom"), words)).isEqualTo(3);
      assertThat(out.toString(StandardCharsets.UTF_8))
          .containsPattern("goals: 0 of 4 .*\nprogram: ended by run\n");
    }

    @Test
    void ctrlCGoesToTheProgramWhichLandsItsDrone() throws Exception {
      List<String> careful =
          unchanged("1", "192.168.10.1", "command", "takeoff", UnchangedProgram.LAND_LATER);
      try (ProgramProcess process = ProgramProcess.run(careful)) {
        assertThat(process.line()).startsWith("ready: ");
        assertThat(process.line()).isEqualTo("in the air");
        process.interrupt();

        assertThat(process.line()).isEqualTo("land: ok");
        assertThat(process.line()).isEqualTo("program: exit code 130");
        assertThat(process.exitCode()).isEqualTo(130);
      }
    }

    @Test
    void aSimulatorThatIsKilledGetsASentence() throws Exception {
      try (ProgramProcess process = ProgramProcess.run(List.of("sleep", NAP))) {
        assertThat(process.line()).startsWith("ready: ");
        assertThat(process.descendants().filter(RunCommandTest::isJava))
            .singleElement()
            .satisfies(ProcessHandle::destroyForcibly);

        assertThat(process.line()).isEqualTo("program: ended by run");
        assertThat(process.exitCode()).isEqualTo(70);
        assertThat(process.errors())
            .contains("The simulator ended before it was asked to, with exit code 137; ");
      }
    }

    /** Processes that ignore signals, fork and use their own session all end with {@code run}. */
    @Test
    void nothingIsLeftOfARunThatIsKilled() throws Exception {
      String forking =
          "trap '' TERM INT HUP; setsid sleep " + NAP + " & echo forked; exec sleep " + NAP;
      try (ProgramProcess process = ProgramProcess.run(List.of("sh", "-c", forking))) {
        assertThat(process.line()).startsWith("ready: ");
        assertThat(process.line()).isEqualTo("forked");
        List<ProcessHandle> all = process.descendants().toList();
        process.kill();

        assertThat(all).hasSizeGreaterThan(4);
        for (ProcessHandle each : all) {
          while (each.isAlive() && each.info().command().isPresent()) { // a zombie has no command
            Thread.onSpinWait();
          }
        }
      }
    }

    /**
     * Returns a script whose {@code "$@"} is an unchanged program that still needs its commands.
     */
    private static List<String> shell(String script) {
      return Stream.concat(
              Stream.of("sh", "-c", script, "script"), unchanged("1", "192.168.10.1").stream())
          .toList();
    }

    /** The drone lands at its start, which is not a goal of this room. */
    @Test
    void otherwiseTheGoalsDecide() {
      assertThat(
              fly(
                  List.of("--scenario", "slalom"),
                  unchanged("1", "192.168.10.1", "command", "takeoff", "land")))
          .isEqualTo(3);
      assertThat(out.toString(StandardCharsets.UTF_8)).contains("goals: 0 of ");
    }
  }

  private static boolean isJava(ProcessHandle process) {
    return process.info().command().filter(command -> command.endsWith("java")).isPresent();
  }
}
