package tellosimulator.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class TemporaryFolderTest {

  @Test
  void itIsDeletedWithAllThatIsInItAndOnce() throws IOException {
    TemporaryFolder folder = TemporaryFolder.create("tello-test");
    Path inner = Files.createDirectories(folder.path().resolve("a").resolve("b"));
    Files.writeString(inner.resolve("file"), "text");

    folder.close();
    folder.close();

    assertThat(folder.path()).doesNotExist();
  }
}
