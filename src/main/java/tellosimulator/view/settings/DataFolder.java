package tellosimulator.view.settings;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** The folder for the files that the program creates for the user. */
public final class DataFolder {

  private static final String RECORDINGS = "recordings";

  private DataFolder() {}

  /** Returns the default folder for recorded flights. */
  public static Path recordings() {
    return usual(System.getProperty("os.name"), System.getProperty("user.home"), System.getenv())
        .resolve(RECORDINGS);
  }

  /**
   * Returns the folder in which an operating system stores application data. Documented: XDG Base
   * Directory Specification, Apple File System Programming Guide, Windows known folders.
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
