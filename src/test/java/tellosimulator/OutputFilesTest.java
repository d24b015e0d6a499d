package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.recording.RecordingFile;
import tellosimulator.recording.RecordingFixture;

/** Checks that no output file overwrites a file that the program reads. */
class OutputFilesTest {

  @TempDir private Path folder;
  private Path recording;
  private Path other;
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @BeforeEach
  void record() {
    recording = RecordingFixture.in(folder.resolve("flight"));
    other = RecordingFixture.in(folder.resolve("other"));
    for (Path each : List.of(recording, other)) {
      new RecordingFixture(each).with("wire.jsonl", "{}\n").with("video-1.mp4", "film");
    }
  }

  private int run(String line, Object... values) {
    return Main.run(
        String.format(Locale.ROOT, line, values).split(" "),
        new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private Map<String, String> contents() throws IOException {
    Map<String, String> contents = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        contents.put(file.toString(), Files.readString(file));
      }
    }
    return contents;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "export %1$s --to pcap -o %2$s",
        "export %1$s --to mcap -o %2$s",
        "report %1$s -o %2$s",
        "diff %1$s %1$s -o %2$s",
        "--headless --report %2$s",
        "--headless --result %2$s"
      })
  void noFileOfARecordingIsWrittenOver(String line) throws IOException {
    Map<String, String> before = contents();
    List<String> names =
        Stream.concat(
                Stream.of(RecordingFile.values()).map(RecordingFile::fileName),
                Stream.of("video-1.mp4"))
            .toList();

    for (Path written : List.of(recording, other)) {
      for (String name : names) {
        err.reset();
        Path file = written.resolve(name);
        assertThat(run(line, recording, file)).as("%s, %s", line, name).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8).lines())
            .singleElement()
            .asString()
            .contains(file + " is a file of a recording, which would be lost; name another file.");
      }
    }

    assertThat(contents()).isEqualTo(before);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aLinkToAFileOfARecordingIsRefusedToo() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("page"), recording.resolve("wire.jsonl"));

    assertThat(run("report %s -o %s", recording, link)).isEqualTo(2);

    assertThat(recording.resolve("wire.jsonl")).hasContent("{}");
  }

  @Test
  void filesOfTheSameNameThatAreNoRecordingCanBeWritten() throws IOException {
    Path file = folder.resolve("run.json");

    assertThat(run("export %s --to mcap -o %s", recording, file)).isZero();
    assertThat(run("export %s --to mcap -o %s", recording, file)).isEqualTo(2);
  }

  @Test
  void theScenarioIsNoPlaceForTheReport() throws IOException {
    Path scenario =
        Files.writeString(
            folder.resolve("room.yaml"), "room: {width: 500, depth: 500, height: 300}\n");

    assertThat(run("--headless --scenario %1$s --report %1$s", scenario)).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .contains("--report " + scenario + ": the simulator reads this file, which would be lost.");
    assertThat(scenario).hasContent("room: {width: 500, depth: 500, height: 300}");
  }
}
