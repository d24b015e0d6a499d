package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Model.OptionSpec;
import tellosimulator.cli.Options;
import tellosimulator.cli.SubcommandName;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.scenario.Gallery;

class MainTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @ParameterizedTest
  @ValueSource(strings = {"--help", "-h", "--help --profile edu"})
  void helpNamesEveryOptionForATerminalOfAnyKind(String line) {
    assertThat(run(line)).isZero();

    assertThat(lines(out)).startsWith("Simulates Tello drones").isASCII();
    List<String> options =
        new Options()
            .commandLine(() -> new String[0]).getCommandSpec().options().stream()
                .filter(option -> !option.hidden())
                .map(OptionSpec::longestName)
                .toList();
    assertThat(options).hasSize(42);
    assertThat(lines(out)).contains(options).contains("--help", "--version");
    for (SubcommandName subcommand : SubcommandName.values()) {
      assertThat(lines(out)).containsPattern("\n  " + subcommand.word() + " +[a-z]");
    }
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
          --drone=3         | There is no option --drone=3, did you mean --drones? Try --help.
          --time_facotr     | There is no option --time_facotr, did you mean --time-factor? Try --help.
          fly               | There is no option fly. Try --help.
          replya x          | There is no option replya, did you mean replay? Try --help.
          @pom.xml          | There is no option @pom.xml. Try --help.
          --bind 224.0.0.1  | Invalid value for option '--bind': expected an address of this machine such as 127.0.0.2, found 224.0.0.1. Try --help.
          --scenario docs   | docs: expected a file, found a folder
          --drones          | Missing required parameter for option '--drones' (N). Try --help.
          --drones 0        | Invalid value for option '--drones': expected a number from 1 to 250, found 0. Try --help.
          --profile=        | Invalid value for option '--profile': expected one of edu, tello, tt, found nothing. Try --help.
          --drones 1 --drones 2 | Option '--drones' (N) should be specified only once. Try --help.
          --poster front,0,120,30,no-such.png | There is no file no-such.png. Try --help.
          --poster front,0,120,30,pom.xml | The file pom.xml is not an image that can be read (PNG, JPEG, GIF or BMP). Try --help.
          --start 9999,0    | Drone 1 does not fit into the room: its start would be at x 9999, y 0 cm. Try --help.
          --scenario nowhere.yaml | nowhere.yaml: there is no such file
          nowhere.yaml      | nowhere.yaml: there is no such file
          nowhere.yaml --headless | Beside options, a scenario file is named by --scenario nowhere.yaml. Try --help.
          --scenario nowhere | Invalid value for option '--scenario': there is neither a file nor a scenario nowhere; there are empty-room, over-the-wall, slalom, table-landing, window-in-the-wall, gate-race, wind, pad-course, wall-pad, swarm-stage. Try --help.
          --scenario slalon  | Invalid value for option '--scenario': there is neither a file nor a scenario slalon, did you mean slalom? Try --help.
          --scenario slalom --drones 2 | --drones does not go with --scenario, which says it. Try --help.
          --scenario slalom --room 500x500x300 | --room does not go with --scenario, which says it. Try --help.
          --scenario slalom --bind 127.0.0.1,127.0.0.2 | --bind has 2 addresses for 1 drones, but each drone needs one. Try --help.
          --headless --exit-when-done | --exit-when-done needs --headless and a --scenario with goals. Try --help.
          --exit-when-done --scenario slalom | --exit-when-done needs --headless and a --scenario with goals. Try --help.
          --control 0 | --control needs --headless. Try --help.
          --web 0 | --web needs --headless. Try --help.
          web --timeout 20 --scenario slalom | --web does not go with --timeout. Try --help.
          web 70000 | Invalid value for option '--web': expected a port from 1 to 65535, or 0 for a free one, found 70000. Try --help.
          --headless --board http://a/?class=1 --exit-when-done --scenario slalom | --board does not go with --exit-when-done. Try --help.
          --headless --name Ada | --name and --team need --board. Try --help.
          --board x | Invalid value for option '--board': expected the address that the board has printed, http://…/?class=…, found x. Try --help.
          board --port x | Invalid value for option '--port': expected a port from 1 to 65535, or 0 for a free one, found x. Try --help.
          --ghost x | --ghost needs --replay. Try --help.
          --headless --replay x | --replay shows a flight in a window; without one, replay FOLDER flies it again, and report FOLDER makes a page of it, which any browser shows. Try --help.
          --replay x --report r.html | --report does not go with --replay. Try --help.
          --replay x --ghost y --record z | --record does not go with --replay. Try --help.
          --scenario slalom --replay x | --scenario does not go with --replay. Try --help.
          --replay x --log-level warn --control 0 | --control does not go with --replay. Try --help.
          --replay x --camera-tilt 0 --camera-fov 80 --drones 2 | --drones does not go with --replay. Try --help.
          --replay x --bind 127.0.0.1 | --bind does not go with --replay. Try --help.
          --replay=         | Invalid value for option '--replay': expected the name of a file or a folder, found nothing. Try --help.
          --headless --record= | Invalid value for option '--record': expected the name of a file or a folder, found nothing. Try --help.
          --headless --report= | Invalid value for option '--report': expected the name of a file or a folder, found nothing. Try --help.
          --exit-when-done --replay x | --exit-when-done does not go with --replay. Try --help.
          --headless --control 70000 | Invalid value for option '--control': expected a port from 1 to 65535, or 0 for a free one, found 70000. Try --help.
          --headless --control 0 --exit-when-done --scenario slalom | --control does not go with --exit-when-done. Try --help.
          --headless --timeout 20 | --timeout needs --headless and a --scenario with goals. Try --help.
          --timeout 20 --scenario slalom | --timeout needs --headless and a --scenario with goals. Try --help.
          --headless --timeout 20 --scenario slalom --control 0 | --control does not go with --timeout. Try --help.
          """)
  void wrongOptionsAreOneSentenceAndExitCodeTwo(String line, String sentence) {
    assertThat(run(line)).isEqualTo(2);

    assertThat(lines(err)).isEqualTo(sentence + "\n");
    assertThat(lines(out)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          report                | 2 | Missing required parameter: 'FOLDER'. Try --help.
          report --fly x        | 2 | There is no option --fly. Try --help.
          report x y            | 2 | There is no option y. Try --help.
          report x -o           | 2 | Missing required parameter for option '--output' (FILE). Try --help.
          report x -o=          | 2 | Invalid value for option '--output': expected the name of a file or a folder, found nothing. Try --help.
          report no-such-folder | 1 | There is no folder no-such-folder; name the folder of a recording.
          report docs           | 1 | docs is no recording, because there is no run.json in it.
          """)
  void aReportThatCannotBeMadeIsOneSentence(String line, int exitCode, String sentence) {
    assertThat(run(line)).isEqualTo(exitCode);

    assertThat(lines(err)).isEqualTo(sentence + "\n");
    assertThat(lines(out)).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(SubcommandName.class)
  void aSubcommandExplainsItself(SubcommandName name) {
    assertThat(run(name.word() + " --help")).isZero();

    assertThat(lines(out))
        .contains("Usage: tello-simulator " + name.word() + " [-hV]", "Exit code", "--version")
        .isASCII();
    assertThat(lines(out).lines()).allMatch(printed -> printed.length() <= 80);
    assertThat(lines(err)).isEmpty();
  }

  @Test
  void aReportNamesItsOptions() {
    assertThat(run("report --help")).isZero();

    assertThat(lines(out)).contains("FOLDER", "-o", "FILE", "Exit code 0: written");
  }

  @Test
  void aReportIsWrittenIntoTheFolderOrToTheFileThatIsNamed(@TempDir Path folder) {
    RecordingFixture.in(folder);
    Path file = folder.resolve("named.html");

    assertThat(run("report " + folder)).isZero();
    assertThat(run("report " + folder + " -o " + file)).isZero();
    assertThat(run("report " + folder + " -o " + folder)).isEqualTo(1);

    assertThat(folder.resolve("report.html")).isNotEmptyFile();
    assertThat(file).isNotEmptyFile();
    assertThat(lines(out))
        .isEqualTo("report: " + folder.resolve("report.html") + "\nreport: " + file + "\n");
    assertThat(lines(err))
        .isEqualTo(
            "The report was not written to %1$s: %1$s is a folder, a pipe or a device, not a file.\n"
                .formatted(folder));
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
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void quitEndsTheProgram() throws Exception {
    try (ProgramProcess program = ProgramProcess.headless()) {
      assertThat(program.port()).isPositive();

      program.type("quit\n");

      assertThat(program.exitCode()).isZero();
    }
  }

  @Test
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void theEndOfInputChangesNothingAndATerminationFreesThePort() throws Exception {
    try (ProgramProcess program = ProgramProcess.headless()) {
      int port = program.port();
      program.type("");
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");

      program.terminate();

      assertThat(program.exitCode()).isEqualTo(143);
      assertThat(ProgramProcess.isFree(port)).isTrue();
    }
  }

  @Test
  void allMistakesOfAScenarioAreToldWithTheirPlaces(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("wrong.yaml"), "walls: high\nrom: 5\n");

    assertThat(run("--scenario " + file)).isEqualTo(2);

    assertThat(lines(err))
        .isEqualTo(
            file
                + ":1:8: expected one of auto, plain, textured, found \"high\"\n"
                + file
                + ":2:1: a scenario has no key \"rom\", did you mean room?\n");
  }

  @Test
  void scenariosAreListedWithWhatTheyTeach() {
    assertThat(run("--scenarios")).isZero();

    assertThat(lines(out).lines()).hasSize(Gallery.NAMES.size());
    assertThat(lines(out)).startsWith("empty-room          to take off, ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          takeoff,land            | 0 | goals: 1 of 1 reached after .*
          takeoff,forward 50,land | 3 | goals: 0 of 1 reached after 5\\.0 s: time is over
          """)
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void theResultOfAScenarioIsALineAndAnExitCode(String commands, int code, String result)
      throws Exception {
    try (ProgramProcess program = landingWithinFiveSeconds()) {
      int port = program.port();
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
      for (String command : commands.split(",", -1)) {
        assertThat(ProgramProcess.ask(command, port)).as("its drone comes down").isEqualTo("ok");
      }

      assertThat(program.line()).matches(result);
      assertThat(program.exitCode()).isEqualTo(code);
    }
  }

  @Test
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void whoLandsWithoutTheGoalsHasMissedThemSoon() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(
            Main.class, "--headless --exit-when-done --time-factor max --scenario slalom", "")) {
      int port = program.port();
      for (String command : List.of("command", "takeoff", "land")) {
        assertThat(ProgramProcess.ask(command, port)).isEqualTo("ok");
      }

      assertThat(program.line())
          .matches(
              "goals: 0 of \\d+ reached after .* s:"
                  + " all drones have landed, and no command came for 15 s");
      assertThat(program.exitCode()).isEqualTo(3);
    }
  }

  @Test
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void pointsAreALineAfterTheGoalsAndPartOfTheResult(@TempDir Path folder) throws Exception {
    Path scenario =
        Files.writeString(
            folder.resolve("points.yaml"),
            """
            goals:
              - reach: {at: [0, 0, 30], points: 10}
              - reach: {at: [0, 0, 200], points: 5}
            scoring: {refused: 1, not-landed: 2}
            """);
    Path result = folder.resolve("result.json");
    String options =
        "--headless --exit-when-done --time-factor max --scenario "
            + scenario
            + " --result "
            + result;
    try (ProgramProcess program = ProgramProcess.start(Main.class, options, "")) {
      int port = program.port();
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
      assertThat(ProgramProcess.ask("takeoff", port)).isEqualTo("ok");
      assertThat(ProgramProcess.ask("up 5000", port)).isNotEqualTo("ok");
      assertThat(ProgramProcess.ask("land", port)).isEqualTo("ok");

      assertThat(program.line()).startsWith("goals: 1 of 2 reached after ");
      assertThat(program.line()).isEqualTo("score: 9 of 15 points");
      assertThat(program.exitCode()).isEqualTo(3);
      assertThat(Files.readString(result))
          .contains("\"verdict\": \"missed\"", "\"points\": 9.0,", "\"of\": 15.0,")
          .contains("\"reason\": \"all drones have landed, and no command came for 15 s\"")
          .contains("\"refused\": 1");
    }
  }

  @Test
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void aProgramThatNeverTakesOffIsEndedByTheTimeout() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(
            Main.class, "--headless --time-factor 100 --scenario slalom --timeout 20", "")) {
      assertThat(program.port()).isPositive();

      assertThat(program.line())
          .matches("goals: 0 of \\d+ reached after 0.0 s: no drone took off within 20 s");
      assertThat(program.exitCode()).isEqualTo(3);
    }
  }

  @Test
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void whoQuitsBeforeTheGoalsAreReachedHasMissedThem() throws Exception {
    try (ProgramProcess program = landingWithinFiveSeconds()) {
      assertThat(program.port()).isPositive();
      program.type("quit\n");

      assertThat(program.line()).isEqualTo("goals: 0 of 1 reached after 0.0 s");
      assertThat(program.exitCode()).isEqualTo(3);
    }
  }

  private static ProgramProcess landingWithinFiveSeconds() throws IOException {
    Path file = Path.of("src", "test", "resources", "landing-within-five-seconds.yaml");
    return ProgramProcess.start(
        Main.class, "--headless --exit-when-done --time-factor max --scenario " + file, "");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void withoutADisplayItSaysSoInOneSentenceAndRunsWithoutAWindow() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(Main.class, "--log-level warn --time-factor max", "DISPLAY")) {
      assertThat(ProgramProcess.ask("command", program.port())).isEqualTo("ok");
      assertThat(program.errors().lines())
          .singleElement()
          .asString()
          .startsWith("There is no display, so the simulator runs without a window.");

      program.type("quit\n");

      assertThat(program.exitCode()).isZero();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  @Tag("process")
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void aReplayWithoutADisplaySaysWhatHelpsInOneSentence(@TempDir Path folder) throws Exception {
    RecordingFixture.in(folder);
    try (ProgramProcess program = ProgramProcess.replay(folder, "DISPLAY")) {
      assertThat(program.exitCode()).isEqualTo(1);
      assertThat(program.errors().lines())
          .containsExactly(
              "There is no display. The replay needs a window; report FOLDER makes a page of the"
                  + " flight, which any browser shows.");
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
}
