package tellosimulator.view.gallery;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyProperty;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/** The recently used files of a kind, newest first. Confined to the JavaFX thread. */
public final class RecentFiles {

  /** Maximum number of files. Decided: they fit into one row of the gallery. */
  static final int MOST = 5;

  private static final String SEPARATOR = ",";

  private final ObjectProperty<List<Path>> files =
      new SimpleObjectProperty<>(this, "files", List.of());

  /**
   * Restores the list from the settings, and saves its changes.
   *
   * @param key the key of the setting
   */
  public static RecentFiles remembered(Settings settings, String key) {
    RecentFiles recent = new RecentFiles();
    settings.bind(key, recent.files, codec());
    return recent;
  }

  /** Puts a file first in the list, and drops the oldest file if there are too many. */
  public void add(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    files.set(
        Stream.concat(
                Stream.of(absolute), files.get().stream().filter(each -> !each.equals(absolute)))
            .limit(MOST)
            .toList());
  }

  /** Returns the newest file that is still there. */
  public Optional<Path> latest() {
    return files.get().stream().filter(Files::exists).findFirst();
  }

  /** The absolute paths of the files. */
  ReadOnlyProperty<List<Path>> filesProperty() {
    return files;
  }

  /**
   * Returns the codec for the files. The codec encodes backslashes and spaces, because settings do
   * not preserve them.
   */
  static SettingCodec<List<Path>> codec() {
    return new SettingCodec<>(
        "at most " + MOST + " paths, percent-encoded, with commas between them",
        RecentFiles::read,
        paths ->
            paths.stream()
                .map(path -> URLEncoder.encode(path.toString(), StandardCharsets.UTF_8))
                .collect(Collectors.joining(SEPARATOR)));
  }

  private static Optional<List<Path>> read(String text) {
    try {
      List<Path> paths =
          Stream.of(text.split(SEPARATOR, -1))
              .map(word -> Path.of(URLDecoder.decode(word, StandardCharsets.UTF_8)))
              .toList();
      return Optional.of(paths)
          .filter(all -> all.size() <= MOST && all.stream().allMatch(Path::isAbsolute));
    } catch (IllegalArgumentException e) { // not percent-encoded, or not a path
      return Optional.empty();
    }
  }
}
