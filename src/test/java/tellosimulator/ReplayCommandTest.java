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
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.testing.Jvm;

/** Tests the subcommand {@code replay} on the command line. */
@Tag("process")
class ReplayCommandTest {

  @TempDir private static Path recordings;
  private static Path recorded;

  @TempDir private Path folder;
  private Path recording;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @BeforeAll
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  static void record() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(
            Main.class, "--headless --time-factor max --record " + recordings, "")) {
      int port = program.port();
      for (String command : List.of("command", "takeoff", "cw 90", "land")) {
        assertThat(ProgramProcess.ask(command, port)).isEqualTo("ok");
      }
      program.type("quit\n");
      assertThat(program.exitCode()).isZero();
    }
    recorded = RecordingFiles.only(recordings).folder();
  }

  @BeforeEach
  void copy() throws IOException {
    recording = Files.createDirectory(folder.resolve("recording"));
    for (Path file : in(recorded)) {
      Files.copy(file, recording.resolve(file.getFileName()));
    }
  }

  private static List<Path> in(Path parent) throws IOException {
    try (Stream<Path> files = Files.list(parent)) {
      return files.toList();
    }
  }

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private List<String> printed() {
    return out.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @Test
  void aRecordingThatNobodyChangedIsIdentical() {
    assertThat(run("replay", recording.toString())).isZero();

    assertThat(printed()).containsExactly("identical");
    assertThat(err.size()).isZero();
  }

  @Test
  void nothingIsLeft() throws Exception {
    Path temporary = Files.createDirectory(folder.resolve("temporary"));
    List<String> command = Jvm.commandOf(Main.class, "replay", recording.toString());
    command.add(1, "-Djava.io.tmpdir=" + temporary);

    Process process = Jvm.process(command).redirectErrorStream(true).start();

    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(said).isZero();
    assertThat(in(temporary)).isEmpty();
  }

  @Test
  void aLineThatWasChangedIsToldWithTheTable() throws IOException {
    Path events = recording.resolve("events.jsonl");
    String text = Files.readString(events);
    String changed = text.replaceFirst("\"reply\": \"ok\"", "\"reply\": \"no\"");
    long line = text.substring(0, text.indexOf("\"reply\": \"ok\"")).lines().count();
    Files.writeString(events, changed);

    assertThat(run("replay", recording.toString())).isEqualTo(4);

    assertThat(printed())
        .startsWith("The flights differ:")
        .element(1)
        .asString()
        .startsWith("  events.jsonl, line " + line + ", at ");
    assertThat(printed().get(2)).startsWith("    recorded: ").contains("\"reply\": \"no\"");
    assertThat(printed().get(3)).startsWith("    replayed: ").contains("\"reply\": \"ok\"");
    assertThat(printed().get(printed().size() - 1)).contains("of 4 commands differ");
  }

  @Test
  void theSecondRecordingIsKeptWhereOneWantsIt() throws IOException {
    Path kept = folder.resolve("kept");

    assertThat(run("replay", recording.toString(), "--record", kept.toString())).isZero();

    Path again = RecordingFiles.only(kept).folder();
    assertThat(printed()).containsExactly("recorded: " + again, "identical");
    assertThat(again.resolve("events.jsonl"))
        .hasSameTextualContentAs(recorded.resolve("events.jsonl"));
  }

  @Test
  void whereNothingCanBeRecordedIsASentence() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));

    assertThat(run("replay", recording.toString(), "--record", file.toString())).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .singleElement()
        .asString()
        .startsWith("The flight was not flown again: ")
        .contains(file + " is in the way");
    assertThat(printed()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          replay no-such-folder | 1 | There is no folder no-such-folder; name the folder of a recording.
          replay docs           | 1 | docs is no recording, because there is no run.json in it.
          replay                | 2 | Missing required parameter: 'FOLDER'. Try --help.
          replay x y            | 2 | There is no option y. Try --help.
          replay x --recrod y   | 2 | There is no option --recrod, did you mean --record? Try --help.
          replay x --record=    | 2 | Invalid value for option '--record': expected the name of a file or a folder, found nothing. Try --help.
          """)
  void whatCannotBeFlownAgainIsASentence(String line, int exitCode, String sentence) {
    assertThat(run(line.split(" ", -1))).isEqualTo(exitCode);

    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualToIgnoringNewLines(sentence);
    assertThat(printed()).isEmpty();
  }
}
