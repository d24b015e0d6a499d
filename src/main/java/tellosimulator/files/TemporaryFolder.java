package tellosimulator.files;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** A temporary folder. Closing it deletes the folder and all of its contents. Thread-safe. */
public final class TemporaryFolder implements AutoCloseable {

  /**
   * Maximum number of attempts to delete the folder. Decided: an attempt can fail because another
   * thread is still creating files in the folder, for example while the program is shutting down.
   */
  private static final int ATTEMPTS = 10;

  private final Path path;

  private TemporaryFolder(Path path) {
    this.path = path;
  }

  /**
   * Creates a folder in the system's temporary directory.
   *
   * @param prefix prefix of the folder's name
   * @throws IOException if the folder cannot be created
   */
  public static TemporaryFolder create(String prefix) throws IOException {
    return new TemporaryFolder(Files.createTempDirectory(prefix));
  }

  public Path path() {
    return path;
  }

  /**
   * Deletes the folder. Files that cannot be deleted remain until the system cleans up its
   * temporary directory. A second call does nothing.
   */
  @Override
  public void close() {
    for (int i = 0; i < ATTEMPTS && Files.exists(path); i++) {
      try {
        deleteAll(path);
      } catch (IOException | UncheckedIOException e) {
        // the contents have changed in the meantime, or cannot be deleted
      }
    }
  }

  /**
   * Deletes a folder and all of its contents; links are deleted, not followed.
   *
   * @throws IOException if the folder does not exist, or something cannot be deleted
   */
  public static void deleteAll(Path folder) throws IOException {
    List<Path> all;
    try (Stream<Path> found = Files.walk(folder)) {
      all = found.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path each : all) {
      Files.deleteIfExists(each);
    }
  }
}
