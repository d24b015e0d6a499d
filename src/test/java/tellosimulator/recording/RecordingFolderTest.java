package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.time.WallTime;

class RecordingFolderTest {

  @TempDir private Path parent;

  private final WallTime now = WallTime.now();

  @Test
  void theNameHasTheMomentAndTheScenario() throws IOException {
    Path made = RecordingFolder.at(parent.resolve("new")).create(now, "Slalom: 3 gates/ä!");

    assertThat(made).isEmptyDirectory();
    assertThat(made.getFileName()).hasToString(now.inFileName() + "_slalom-3-gates");
    assertThat(now.inFileName())
        .matches("20[0-9]{2}-[01][0-9]-[0-3][0-9]_[0-9]{2}-[0-9]{2}-[0-9]{2}");
  }

  @Test
  void twoRecordingsNeverShareAFolder() throws IOException {
    RecordingFolder folder = RecordingFolder.at(parent);

    assertThat(Stream.of(folder.create(now, ""), folder.create(now, "/"), folder.create(now, "..")))
        .map(made -> made.getFileName().toString().replace(now.inFileName(), ""))
        .containsExactly("_flight", "_flight_2", "_flight_3");
  }

  @Test
  void aFileInTheWayIsAnError() throws IOException {
    Path file = Files.createFile(parent.resolve("file"));

    assertThatThrownBy(() -> RecordingFolder.at(file).create(now, ""))
        .isInstanceOf(IOException.class);
  }

  @Test
  void theOldestRecordingsAreDeletedAndNothingElse() throws IOException {
    recording("2026-01-01_10-00-00_a");
    recording("2026-01-01_10-00-01_b");
    recording("2026-01-01_10-00-02_c");
    recording("2026-01-01_10-00-03_d");
    Files.createDirectories(recording("2026-01-01_09-00-00_with-a-folder").resolve("mine"));
    recording("2025-my-best-flight");
    Files.createDirectory(parent.resolve("2020-01-01_10-00-00_no-recording"));
    Files.createFile(parent.resolve("2020-01-01_10-00-00_file"));

    RecordingFolder.keeping(parent, 2).deleteOld();

    try (Stream<Path> left = Files.list(parent)) {
      assertThat(left.map(path -> path.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "2026-01-01_10-00-02_c",
              "2026-01-01_10-00-03_d",
              "2026-01-01_09-00-00_with-a-folder",
              "2025-my-best-flight",
              "2020-01-01_10-00-00_no-recording",
              "2020-01-01_10-00-00_file");
    }
    assertThat(parent.resolve("2026-01-01_09-00-00_with-a-folder/run.json")).exists();
  }

  @Test
  void withoutALimitNothingIsDeleted() throws IOException {
    recording("2026-01-01_10-00-00_a");

    RecordingFolder.at(parent).deleteOld();

    assertThat(parent.resolve("2026-01-01_10-00-00_a/run.json")).exists();
  }

  private Path recording(String name) throws IOException {
    Path folder = Files.createDirectory(parent.resolve(name));
    Files.createFile(folder.resolve("run.json"));
    Files.createFile(folder.resolve("wire.jsonl"));
    return folder;
  }
}
