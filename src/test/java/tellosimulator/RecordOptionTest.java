package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.replay.Repetition;
import tellosimulator.replay.Replay;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.words.Phrase;

/** Tests the program with {@code --record}. */
@Tag("process")
class RecordOptionTest {

  @TempDir private Path folder;

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void aFlightIsRecordedWithAllThatWasOnTheWire() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(
            Main.class,
            "--headless --time-factor max --scenario table-landing --record " + folder,
            "")) {
      int port = program.port();
      for (String command : List.of("command", "battery?", "takeoff", "up 50", "</b>", "land")) {
        assertThat(ProgramProcess.ask(command, port)).isNotEmpty();
      }
      program.type("quit\n");
      assertThat(program.exitCode()).isZero();
    }

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(files.run())
        .containsKeys("program", "begun", "started", "ended", "room")
        .containsEntry("timeFactor", "max")
        .containsEntry("result", "open");
    assertThat((List<?>) files.run().get("options")).asString().contains("--record");
    assertThat(files.wire("command"))
        .extracting(datagram -> datagram.get("text"))
        .containsExactly("command", "battery?", "takeoff", "up 50", "</b>", "land");
    assertThat(files.wire("reply"))
        .extracting(datagram -> datagram.get("text"))
        .containsExactly("ok", "100\r\n", "ok", "ok", "unknown command: </b>", "ok");
    assertThat(files.wire("state")).isNotEmpty();
    assertThat(files.objects("wire.jsonl"))
        .isSortedAccordingTo((a, b) -> Double.compare((double) a.get("t"), (double) b.get("t")));
    assertThat(files.events("took-off", "landed")).hasSize(2);
    assertThat(files.rows()).allSatisfy(row -> assertThat(row).hasSize(23));
    assertThat(files.rows().get(files.rows().size() - 1).get(18)).as("range").isNotEmpty();
    assertThat(files.goals()).isNotEmpty();
    assertThat(ScenarioFile.read(files.folder().resolve("scenario.yaml")).challenge().goals())
        .hasSameSizeAs(files.goals());
  }

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void ofAProgramThatIsKilledAllFilesAreReadable() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(Main.class, "--headless --time-factor 5 --record " + folder, "")) {
      int port = program.port();
      ProgramProcess.ask("command", port);
      ProgramProcess.ask("takeoff", port);
      while (recordedRows() <= 60) {
        assertThat(ProgramProcess.ask("height?", port)).isNotEmpty();
      }
      program.kill();
    }

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(files.run()).containsKey("started").doesNotContainKey("ended");
    for (String name : List.of("wire.jsonl", "events.jsonl", "inputs.jsonl")) {
      assertThat(whole(files.text(name)))
          .isNotEmpty()
          .allSatisfy(line -> assertThat(Json.value(line)).isInstanceOf(Map.class));
    }
    assertThat(whole(files.text("flight.csv")).skip(1))
        .hasSizeGreaterThanOrEqualTo(60)
        .allSatisfy(line -> assertThat(line.split(",", -1)).hasSize(23));
    assertThat(files.has("scenario.yaml")).isTrue();
    Repetition repetition =
        Replay.of(files.folder()).repeat(RecordingFolder.at(folder.resolve("again")));
    assertThat(repetition.differences()).isEmpty();
    assertThat(repetition.remarks())
        .extracting(Phrase::english)
        .singleElement()
        .asString()
        .contains("cut off");
  }

  private long recordedRows() throws IOException {
    List<RecordingFiles> found = RecordingFiles.in(folder);
    return found.isEmpty() || !found.get(0).has("flight.csv")
        ? 0
        : found.get(0).text("flight.csv").lines().count();
  }

  /** Returns the lines that have a line end. */
  private static Stream<String> whole(String text) {
    return text.substring(0, text.lastIndexOf('\n') + 1).lines();
  }

  @Test
  void aFolderThatCannotBeMadeIsASentenceBeforeTheStart() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    ByteArrayOutputStream out = new ByteArrayOutputStream();

    int status =
        Main.run(
            new String[] {"--headless", "--record", file.toString()},
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));

    assertThat(status).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .singleElement()
        .asString()
        .startsWith("--record " + file)
        .contains("no flight can be recorded there")
        .endsWith("Try --help.");
    assertThat(out.size()).isZero();
  }
}
