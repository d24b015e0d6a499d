package tellosimulator.view.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class UserFolderTest {

  private static final String HOME = Path.of("").toAbsolutePath().toString();

  @Test
  void liesWhereTheSystemKeepsSuchThings() {
    assertThat(UserFolder.DATA.path("Linux", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, ".local", "share", "tello-simulator"));
    assertThat(UserFolder.DATA.path("Mac OS X", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "Library", "Application Support", "tello-simulator"));
    assertThat(UserFolder.DATA.path("Windows 11", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "AppData", "Local", "tello-simulator"));
  }

  @Test
  void followsTheEnvironmentIfItNamesAnAbsolutePath() {
    String elsewhere = Path.of(HOME, "elsewhere").toString();
    Path expected = Path.of(elsewhere, "tello-simulator");

    assertThat(UserFolder.DATA.path("Linux", HOME, Map.of("XDG_DATA_HOME", elsewhere)))
        .isEqualTo(expected);
    assertThat(UserFolder.DATA.path("Windows 11", HOME, Map.of("LOCALAPPDATA", elsewhere)))
        .isEqualTo(expected);
    assertThat(UserFolder.DATA.path("Linux", HOME, Map.of("XDG_DATA_HOME", "relative")))
        .isEqualTo(Path.of(HOME, ".local", "share", "tello-simulator"));
  }

  @Test
  void settingsLieWhereTheSystemKeepsThem() {
    assertThat(UserFolder.SETTINGS.path("Linux", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, ".config", "tello-simulator"));
    assertThat(UserFolder.SETTINGS.path("Mac OS X", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "Library", "Application Support", "tello-simulator"));
    assertThat(UserFolder.SETTINGS.path("Windows 11", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "AppData", "Roaming", "tello-simulator"));
  }

  @Test
  void settingsFollowTheEnvironmentIfItNamesAnAbsolutePath() {
    String elsewhere = Path.of(HOME, "elsewhere").toString();
    Path expected = Path.of(elsewhere, "tello-simulator");

    assertThat(UserFolder.SETTINGS.path("Linux", HOME, Map.of("XDG_CONFIG_HOME", elsewhere)))
        .isEqualTo(expected);
    assertThat(UserFolder.SETTINGS.path("Windows 11", HOME, Map.of("APPDATA", elsewhere)))
        .isEqualTo(expected);
    for (String invalid : List.of("relative", "", "/bad\0name")) {
      assertThat(UserFolder.SETTINGS.path("Linux", HOME, Map.of("XDG_CONFIG_HOME", invalid)))
          .isEqualTo(Path.of(HOME, ".config", "tello-simulator"));
    }
  }
}
