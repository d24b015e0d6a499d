package tellosimulator.view.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SettingsFileTest {

  private static final String HOME = Path.of("").toAbsolutePath().toString();

  @Test
  void liesWhereTheSystemKeepsSuchFiles() {
    assertThat(SettingsFile.usual("Linux", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, ".config", "tello-simulator", "settings.properties"));
    assertThat(SettingsFile.usual("Mac OS X", HOME, Map.of()))
        .isEqualTo(
            Path.of(
                HOME, "Library", "Application Support", "tello-simulator", "settings.properties"));
    assertThat(SettingsFile.usual("Windows 11", HOME, Map.of()))
        .isEqualTo(Path.of(HOME, "AppData", "Roaming", "tello-simulator", "settings.properties"));
  }

  @Test
  void followsTheEnvironmentIfItNamesAnAbsolutePath() {
    String elsewhere = Path.of(HOME, "elsewhere").toString();
    Path expected = Path.of(elsewhere, "tello-simulator", "settings.properties");

    assertThat(SettingsFile.usual("Linux", HOME, Map.of("XDG_CONFIG_HOME", elsewhere)))
        .isEqualTo(expected);
    assertThat(SettingsFile.usual("Windows 11", HOME, Map.of("APPDATA", elsewhere)))
        .isEqualTo(expected);
    assertThat(SettingsFile.usual("Linux", HOME, Map.of("XDG_CONFIG_HOME", "relative")))
        .startsWithRaw(Path.of(HOME, ".config"));
    assertThat(SettingsFile.usual("Linux", HOME, Map.of("XDG_CONFIG_HOME", "")))
        .startsWithRaw(Path.of(HOME, ".config"));
    assertThat(SettingsFile.usual("Linux", HOME, Map.of("XDG_CONFIG_HOME", "/bad\0name")))
        .startsWithRaw(Path.of(HOME, ".config"));
  }
}
