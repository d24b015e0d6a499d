package tellosimulator.view.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

class DataFolderTest {

  private static final String HOME = Path.of("").toAbsolutePath().toString();

  @Test
  void liesWhereTheSystemKeepsSuchThings() {
    assertThat(DataFolder.usual("Linux", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, ".local", "share", "tello-simulator"));
    assertThat(DataFolder.usual("Mac OS X", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "Library", "Application Support", "tello-simulator"));
    assertThat(DataFolder.usual("Windows 11", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "AppData", "Local", "tello-simulator"));
  }

  @Test
  void followsTheEnvironmentIfItNamesAnAbsolutePath() {
    String elsewhere = Path.of(HOME, "elsewhere").toString();
    Path expected = Path.of(elsewhere, "tello-simulator");

    assertThat(DataFolder.usual("Linux", HOME, Map.of("XDG_DATA_HOME", elsewhere)))
        .isEqualTo(expected);
    assertThat(DataFolder.usual("Windows 11", HOME, Map.of("LOCALAPPDATA", elsewhere)))
        .isEqualTo(expected);
    assertThat(DataFolder.usual("Linux", HOME, Map.of("XDG_DATA_HOME", "relative")))
        .isEqualTo(Path.of(HOME, ".local", "share", "tello-simulator"));
  }
}
