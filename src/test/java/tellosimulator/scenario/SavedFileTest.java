package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests saving a document to its file. */
class SavedFileTest {

  private static final String TEXT = "# mine\nname: Room\n";

  @TempDir private Path folder;
  @TempDir private Path source;

  @Test
  void nothingIsLeftBesideASavedFile() throws Exception {
    Path file = folder.resolve("room.yaml");

    ScenarioFile.write(document(), file);

    assertThat(file).hasContent(TEXT);
    assertThat(files()).containsExactly(file);
  }

  @Test
  void whatCannotBeWrittenLeavesTheOldFileAsItWas() throws Exception {
    Path file = Files.writeString(folder.resolve("room.yaml"), "old");
    String beside = "." + file.getFileName() + "." + ProcessHandle.current().pid();
    Files.createDirectories(folder.resolve(beside).resolve("in the way"));

    assertThatThrownBy(() -> ScenarioFile.write(document(), file)).isInstanceOf(IOException.class);

    assertThat(file).hasContent("old");
  }

  @Test
  void aFileThatMayNotBeWrittenStays() throws Exception {
    Path file = Files.writeString(folder.resolve("room.yaml"), "old");
    assumeTrue(file.toFile().setReadOnly() && !Files.isWritable(file), "nothing is forbidden here");

    assertThatThrownBy(() -> ScenarioFile.write(document(), file))
        .isInstanceOf(AccessDeniedException.class);

    assertThat(file).hasContent("old");
  }

  @Test
  void permissionsAndLinksStay() throws Exception {
    Path file = Files.writeString(folder.resolve("room.yaml"), "old");
    assumeTrue(Files.getFileAttributeView(file, PosixFileAttributeView.class) != null);
    Set<PosixFilePermission> permissions = PosixFilePermissions.fromString("rw-rw-r--");
    Files.setPosixFilePermissions(file, permissions);
    Path link = Files.createSymbolicLink(folder.resolve("link.yaml"), file);

    ScenarioFile.write(document(), link);

    assertThat(link).isSymbolicLink();
    assertThat(file).hasContent(TEXT);
    assertThat(Files.getPosixFilePermissions(file)).isEqualTo(permissions);
  }

  @Test
  void anotherProgramsChangeIsNoticed() throws Exception {
    Path file = folder.resolve("room.yaml");
    assertThat(ScenarioFile.holds(file, document())).as("nothing can be lost").isTrue();
    Files.writeString(file, TEXT);
    assertThat(ScenarioFile.holds(file, document())).isTrue();
    Files.writeString(file, TEXT.replace("mine", "Mine"));
    assertThat(ScenarioFile.holds(file, document())).isFalse();
  }

  private ScenarioDocument document() throws IOException, ScenarioException {
    return ScenarioFile.open(Files.writeString(source.resolve("read.yaml"), TEXT));
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.toList();
    }
  }
}
