package tellosimulator.view.gallery;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
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

/** The scenario files that were opened or saved last, the newest first. For the JavaFX thread. */
public final class RecentFiles {

  /** How many are remembered. Decided: one row of the gallery. */
  static final int MOST = 5;

  private static final String SEPARATOR = ",";

  private final ObjectProperty<List<Path>> files =
      new SimpleObjectProperty<>(this, "files", List.of());

  /** Those of the last time; from now on they are remembered. */
  public static RecentFiles remembered(Settings settings) {
    RecentFiles recent = new RecentFiles();
    settings.bind("recent-files", recent.files, codec());
    return recent;
  }

  /** A file has been opened or saved. */
  public void add(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    files.set(
        Stream.concat(
                Stream.of(absolute), files.get().stream().filter(each -> !each.equals(absolute)))
            .limit(MOST)
            .toList());
  }

  /** Absolute paths. */
  ReadOnlyProperty<List<Path>> filesProperty() {
    return files;
  }

  /** Without backslashes and blanks, which the settings do not keep as they are. */
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
    } catch (IllegalArgumentException e) { // neither encoded like this nor a path
      return Optional.empty();
    }
  }
}
