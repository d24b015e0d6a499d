package tellosimulator.files;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * A folder for files that nobody wants to keep, deleted with all that is in it when it is closed.
 * For any thread.
 */
public final class TemporaryFolder implements AutoCloseable {

  /** Another thread may still make files in it, as when the program is told to end. Decided. */
  private static final int ATTEMPTS = 10;

  private final Path path;

  private TemporaryFolder(Path path) {
    this.path = path;
  }

  /**
   * Makes one where the system keeps such things.
   *
   * @param prefix of its name
   * @throws IOException if there can be none
   */
  public static TemporaryFolder create(String prefix) throws IOException {
    return new TemporaryFolder(Files.createTempDirectory(prefix));
  }

  public Path path() {
    return path;
  }

  /** What cannot be deleted stays: the system cleans up. Does nothing the second time. */
  @Override
  public void close() {
    for (int i = 0; i < ATTEMPTS && Files.exists(path); i++) {
      try {
        deleteAll();
      } catch (IOException | UncheckedIOException e) {
        // something has appeared or gone meanwhile, or cannot be deleted
      }
    }
  }

  private void deleteAll() throws IOException {
    List<Path> all;
    try (Stream<Path> found = Files.walk(path)) {
      all = found.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path each : all) {
      Files.deleteIfExists(each);
    }
  }
}
