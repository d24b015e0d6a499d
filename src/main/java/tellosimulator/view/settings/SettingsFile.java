package tellosimulator.view.settings;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.SortedMap;
import java.util.TreeMap;
import tellosimulator.files.AtomicFile;

/** The file in which settings are stored as text keys and values. */
record SettingsFile(Path path) {

  /**
   * Size above which a file is rejected [bytes]. Decided: about a thousand times the usual size.
   */
  static final int LARGEST = 1 << 20;

  private static final String NAME = "settings.properties";

  /** Returns the path of the file for this user on this system. */
  static Path usual() {
    return UserFolder.SETTINGS.path().resolve(NAME);
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
   * Replaces the file atomically, so that no reader sees an incomplete file.
   *
   * @throws IOException if the file cannot be written; it is then unchanged
   */
  void write(SortedMap<String, String> values) throws IOException {
    StringBuilder text =
        new StringBuilder("# Settings of the Tello Simulator; what is not here has its default.\n");
    values.forEach((key, value) -> text.append(key).append('=').append(value).append('\n'));
    Files.createDirectories(path.toAbsolutePath().getParent());
    AtomicFile.write(path, out -> out.write(text.toString().getBytes(StandardCharsets.UTF_8)));
  }
}
