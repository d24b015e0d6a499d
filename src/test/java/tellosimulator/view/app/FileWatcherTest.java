package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileWatcherTest {

  private static final long SECOND = 1_000_000_000;

  @TempDir private Path folder;
  private Path file;
  private FileWatcher watch;
  private long now;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("room.yaml");
    Files.writeString(file, "first");
    watch = new FileWatcher(file);
  }

  @Test
  void nothingHasChangedUntilSomebodyWrites() {
    assertThat(later()).isFalse();
    assertThat(later()).isFalse();
  }

  @Test
  void aChangeIsToldOnceWhenItHasBeenThereForASecond() throws IOException {
    Files.writeString(file, "the second one");

    assertThat(later()).as("it may still be written").isFalse();
    assertThat(later()).isTrue();
    assertThat(later()).isFalse();
  }

  @Test
  void aFileThatGrowsIsNotRead() throws IOException {
    Files.writeString(file, "the second");
    assertThat(later()).isFalse();
    Files.writeString(file, "the second one");
    assertThat(later()).isFalse();

    assertThat(later()).isTrue();
  }

  @Test
  void aFileThatIsGoneIsAwaited() throws IOException {
    Files.delete(file);
    assertThat(later()).isFalse();
    assertThat(later()).isFalse();

    Files.writeString(file, "back again");
    later();
    assertThat(later()).isTrue();
  }

  @Test
  void itLooksOnceASecond() throws IOException {
    later();
    Files.writeString(file, "the second one");

    for (int i = 0; i < 9; i++) {
      now += SECOND / 10;
      assertThat(watch.changed(now)).isFalse();
    }
    now += SECOND / 10;
    watch.changed(now);
    assertThat(later()).isTrue();
  }

  private boolean later() {
    now += SECOND;
    return watch.changed(now);
  }
}
