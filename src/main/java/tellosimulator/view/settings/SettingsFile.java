package tellosimulator.view.settings;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.SortedMap;
import java.util.TreeMap;

/** The file in which settings are stored as text keys and values. */
record SettingsFile(Path path) {

  /**
   * Size above which a file is rejected [bytes]. Decided: about a thousand times the usual size.
   */
  static final int LARGEST = 1 << 20;

  /** The name of the program's folders. */
  static final String DIRECTORY = "tello-simulator";

  private static final String NAME = "settings.properties";

  /** Returns the path of the file for this user on this system. */
  static Path usual() {
    return usual(System.getProperty("os.name"), System.getProperty("user.home"), System.getenv());
  }

  /**
   * Returns the path of the file on an operating system. Documented: XDG Base Directory
   * Specification, Apple File System Programming Guide, Windows known folders.
   */
  static Path usual(String system, String home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("mac")) {
      return Path.of(home, "Library", "Application Support", DIRECTORY, NAME);
    }
    if (name.contains("windows")) {
      return absolute(environment.get("APPDATA"))
          .orElse(Path.of(home, "AppData", "Roaming"))
          .resolve(DIRECTORY)
          .resolve(NAME);
    }
    return absolute(environment.get("XDG_CONFIG_HOME"))
        .orElse(Path.of(home, ".config"))
        .resolve(DIRECTORY)
        .resolve(NAME);
  }

  /** Returns the path in an environment variable; empty unless it is a valid absolute path. */
  static Optional<Path> absolute(String text) {
    try {
      return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /**
   * Reads all values; returns an empty map if the file does not exist.
   *
   * @throws IOException if the file cannot be read or is malformed; the message may continue a
   *     sentence about the file, such as "is not a file"
   */
  Map<String, String> read() throws IOException {
    if (Files.notExists(path)) {
      return Map.of();
    }
    if (!Files.isRegularFile(path)) {
      throw new IOException("is not a file");
    }
    Properties properties = new Properties();
    try {
      properties.load(new StringReader(text()));
    } catch (IllegalArgumentException e) {
      throw new IOException("holds no settings: four hexadecimal digits must follow a \\u", e);
    }
    Map<String, String> values = new TreeMap<>();
    properties.stringPropertyNames().forEach(key -> values.put(key, properties.getProperty(key)));
    return values;
  }

  private String text() throws IOException {
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(LARGEST + 1);
      if (bytes.length > LARGEST) {
        throw new IOException("is larger than " + LARGEST + " bytes");
      }
      return new String(bytes, StandardCharsets.UTF_8);
    }
  }

  /**
   * Replaces the file, atomically if the file system allows it, so that no reader sees an
   * incomplete file.
   *
   * @throws IOException if the file cannot be written; it is then unchanged
   */
  void write(SortedMap<String, String> values) throws IOException {
    Path target = Files.exists(path) ? path.toRealPath() : path.toAbsolutePath();
    Files.createDirectories(target.getParent());
    Path draft = Files.createTempFile(target.getParent(), NAME, ".new");
    try {
      try (BufferedWriter out = Files.newBufferedWriter(draft)) {
        out.write("# Settings of the Tello Simulator; what is not here has its default.\n");
        for (Map.Entry<String, String> entry : values.entrySet()) {
          out.write(entry.getKey() + "=" + entry.getValue() + "\n");
        }
      }
      replace(draft, target);
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  private static void replace(Path draft, Path target) throws IOException {
    try {
      Files.move(draft, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(draft, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}
