package tellosimulator.view.app;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The folder into which JavaFX unpacks its native libraries on its first start. By default, the
 * folder is in the user's home directory. If the disk with that directory is full, JavaFX fails
 * with a message about missing libraries. Confined to the main thread.
 *
 * @param usual JavaFX's default folder
 * @param temporary a folder in which a replacement can be created
 * @param needed the space that the libraries need [bytes]
 */
record NativeCache(Path usual, Path temporary, long needed) {

  /** The system property that makes JavaFX use another folder. */
  static final String PROPERTY = "javafx.cachedir";

  /**
   * The default for the needed space, with a margin [bytes]. Measured: OpenJFX 21.0.12 unpacks up
   * to 5 MB for a window on Linux.
   */
  private static final long NEEDED = 8L << 20;

  /** The number of levels from the folder down to a library: version, processor, and file name. */
  private static final int DEPTH = 3;

  /** Returns the cache of the current user on this machine. */
  static NativeCache ofThisUser() {
    return new NativeCache(
        Path.of(System.getProperty("user.home"), ".openjfx", "cache"),
        Path.of(System.getProperty("java.io.tmpdir")),
        NEEDED);
  }

  /**
   * Makes JavaFX use a folder with enough space. If that is not the default folder, sets {@link
   * #PROPERTY}. Does nothing if the property is already set.
   *
   * @return false if neither folder has enough space
   */
  boolean prepare() {
    if (System.getProperty(PROPERTY) != null) {
      return true;
    }
    Optional<Path> folder = folder();
    folder
        .filter(chosen -> !chosen.equals(usual))
        .ifPresent(chosen -> System.setProperty(PROPERTY, chosen.toString()));
    return folder.isPresent();
  }

  /**
   * Returns the default folder if it already contains the libraries or has enough space, or else a
   * new temporary folder; empty if neither has enough space.
   */
  Optional<Path> folder() {
    if (holdsLibraries() || canHold(usual)) {
      return Optional.of(usual);
    }
    try {
      Path other = Files.createTempDirectory(temporary, "openjfx");
      if (canHold(other)) {
        return Optional.of(other);
      }
      Files.delete(other);
      return Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private boolean holdsLibraries() {
    String library = System.mapLibraryName("glass");
    try (Stream<Path> files =
        Files.find(usual, DEPTH, (path, is) -> path.endsWith(library) && is.isRegularFile())) {
      return files.findAny().isPresent();
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Creates a folder if it is missing, and returns whether it has enough space. Tests this by
   * writing a file, because the usable space that the system reports ignores quotas.
   */
  private boolean canHold(Path folder) {
    try {
      Files.createDirectories(folder);
      if (Files.getFileStore(folder).getUsableSpace() < needed) {
        return false;
      }
      Path trial = Files.createTempFile(folder, "trial", "");
      try (OutputStream out = Files.newOutputStream(trial)) {
        byte[] block = new byte[1 << 16];
        for (long written = 0; written < needed; written += block.length) {
          out.write(block);
        }
        return true;
      } finally {
        Files.delete(trial);
      }
    } catch (IOException e) {
      return false;
    }
  }
}
