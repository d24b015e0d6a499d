package tellosimulator.view.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.view.settings.Settings;

class RecentFilesTest {

  @TempDir private Path folder;

  @Test
  void theNewestComesFirstAndEachOnceAndTheOldestAreForgotten() {
    RecentFiles recent = RecentFiles.remembered(load(), "recent-files");
    for (int i = 0; i < RecentFiles.MOST + 1; i++) {
      recent.add(folder.resolve(i + ".yaml"));
    }

    recent.add(folder.resolve("3.yaml"));

    assertThat(recent.filesProperty().getValue())
        .extracting(file -> file.getFileName().toString())
        .containsExactly("3.yaml", "5.yaml", "4.yaml", "2.yaml", "1.yaml");
  }

  @Test
  void theyAreThereTheNextTimeWhateverTheirNames() {
    Settings settings = load();
    Path odd = folder.resolve("Räume, 5 % & =+").resolve("a b;c.yaml");
    RecentFiles.remembered(settings, "recent-files").add(odd);
    RecentFiles.remembered(reopened(settings), "recent-files").add(folder.resolve("next.yaml"));

    Settings again = load();
    RecentFiles recent = RecentFiles.remembered(again, "recent-files");

    assertThat(recent.filesProperty().getValue()).containsExactly(odd);
  }

  private Settings reopened(Settings settings) {
    settings.save();
    return load();
  }

  @Test
  void aRelativePathIsKeptAsWhereItIs() {
    RecentFiles recent = RecentFiles.remembered(load(), "recent-files");

    recent.add(Path.of("x", "..", "room.yaml"));

    assertThat(recent.filesProperty().getValue())
        .containsExactly(Path.of("room.yaml").toAbsolutePath());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "room.yaml", "%", "%zz", "%2Fa,,%2Fb", "%2Fa%00", "/a,/a,/a,/a,/a,/a"})
  void whatNobodyWroteIsNotRead(String text) {
    assertThat(RecentFiles.codec().read().apply(text)).isEmpty();
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    List<Path> paths = List.of(folder.resolve("a"), folder.resolve("b c"));
    String text = RecentFiles.codec().write().apply(paths);

    assertThat(text).doesNotContain(" ", "\\", "=");
    assertThat(RecentFiles.codec().read().apply(text)).contains(paths);
  }

  private Settings load() {
    return Settings.load(folder.resolve("settings.properties"));
  }
}
