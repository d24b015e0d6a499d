package tellosimulator.view.settings;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** The folder in which the program keeps what it makes for a person. */
public final class DataFolder {

  private static final String RECORDINGS = "recordings";

  private DataFolder() {}

  /** Where flights are recorded unless somebody says otherwise. */
  public static Path recordings() {
    return usual(System.getProperty("os.name"), System.getProperty("user.home"), System.getenv())
        .resolve(RECORDINGS);
  }

  /**
   * Where a system keeps such things. Documented: XDG Base Directory Specification, Apple File
   * System Programming Guide, Windows known folders.
   */
  static Path usual(String system, String home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("mac")) {
      return Path.of(home, "Library", "Application Support", SettingsFile.DIRECTORY);
    }
    if (name.contains("windows")) {
      return SettingsFile.absolute(environment.get("LOCALAPPDATA"))
          .orElse(Path.of(home, "AppData", "Local"))
          .resolve(SettingsFile.DIRECTORY);
    }
    return SettingsFile.absolute(environment.get("XDG_DATA_HOME"))
        .orElse(Path.of(home, ".local", "share"))
        .resolve(SettingsFile.DIRECTORY);
  }
}
