package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the program with {@code --report}. */
@Tag("process")
class ReportOptionTest {

  @TempDir private Path folder;

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void aFlightHasAReportAlsoWhenTheProgramIsToldToEnd() throws Exception {
    Path file = folder.resolve("flight.html");
    try (ProgramProcess program = start("--report " + file)) {
      ask(program, "command", "takeoff", "cw 90");
      program.terminate();
      program.exitCode();
    }

    assertThat(names()).containsExactly("flight.html");
    assertThat(file).content().contains("<title>").contains("\"cw 90\"");
  }

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void recordingsThatAreWantedAreKept() throws Exception {
    Path recordings = folder.resolve("recordings");
    Path file = folder.resolve("flight.html");
    try (ProgramProcess program = start("--record " + recordings + " --report " + file)) {
      ask(program, "command", "takeoff", "land");
      program.type("quit\n");
      assertThat(program.exitCode()).isZero();
    }

    assertThat(names()).containsExactly("flight.html", "recordings");
    try (Stream<Path> kept = Files.list(recordings)) {
      assertThat(kept).singleElement().matches(each -> Files.exists(each.resolve("run.json")));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --report x.html                       | --report needs --headless. Try --help.
          --headless --report docs              | --report docs: expected a file, found a folder. Try --help.
          --headless --report no/such/x.html    | --report no/such/x.html: there is no folder
          """)
  void aReportThatCannotBeThereIsASentenceBeforeTheStart(String line, String sentence) {
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    PrintStream none = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);

    int status =
        Main.run(line.split(" "), none, new PrintStream(err, true, StandardCharsets.UTF_8));

    assertThat(status).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .singleElement()
        .asString()
        .startsWith(sentence);
  }

  private static ProgramProcess start(String options) throws IOException {
    return ProgramProcess.start(Main.class, "--headless --time-factor max " + options, "");
  }

  private static void ask(ProgramProcess program, String... commands) throws Exception {
    int port = program.port();
    for (String command : commands) {
      assertThat(ProgramProcess.ask(command, port)).isEqualTo("ok");
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }
}
