package tellosimulator.view.settings;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The folders for the files that the program creates for the user. Documented: XDG Base Directory
 * Specification, Apple File System Programming Guide, Windows known folders.
 */
public enum UserFolder {
  SETTINGS("APPDATA", "AppData/Roaming", "XDG_CONFIG_HOME", ".config"),
  DATA("LOCALAPPDATA", "AppData/Local", "XDG_DATA_HOME", ".local/share");

  private static final String NAME = "tello-simulator";

  private final String windowsVariable;
  private final String windowsDefault;
  private final String xdgVariable;
  private final String xdgDefault;

  UserFolder(String windowsVariable, String windowsDefault, String xdgVariable, String xdgDefault) {
    this.windowsVariable = windowsVariable;
    this.windowsDefault = windowsDefault;
    this.xdgVariable = xdgVariable;
    this.xdgDefault = xdgDefault;
  }

  /** Returns the default folder for recorded flights. */
  public static Path recordings() {
    return DATA.path().resolve("recordings");
  }

  /** Returns the path of the folder for this user on this system. */
  Path path() {
    return path(System.getProperty("os.name"), System.getProperty("user.home"), System.getenv());
  }

  /** Returns the path of the folder on an operating system. */
  Path path(String system, String home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("mac")) {
      return Path.of(home, "Library", "Application Support", NAME);
    }
    boolean windows = name.contains("windows");
    return absolute(environment.get(windows ? windowsVariable : xdgVariable))
        .orElse(Path.of(home, windows ? windowsDefault : xdgDefault))
        .resolve(NAME);
  }

  /** Returns the path in an environment variable; empty unless it is a valid absolute path. */
  private static Optional<Path> absolute(String text) {
    try {
      return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }
}
