package tellosimulator.view.app;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Where JavaFX unpacks its native libraries at the first start. It takes a folder in the user's
 * home and fails, with words about missing libraries, if that is full. For the main thread.
 *
 * @param usual JavaFX's own choice
 * @param temporary where a folder can be made instead
 * @param needed by the libraries [bytes]
 */
record NativeCache(Path usual, Path temporary, long needed) {

  /** JavaFX's property for another folder. */
  static final String PROPERTY = "javafx.cachedir";

  /** Measured: OpenJFX 21.0.12 unpacks up to 5 MB for a window on Linux. */
  private static final long NEEDED = 8L << 20;

  /** Of a library below the folder: version, processor, file. */
  private static final int DEPTH = 3;

  /** That of this user on this machine. */
  static NativeCache ofThisUser() {
    return new NativeCache(
        Path.of(System.getProperty("user.home"), ".openjfx", "cache"),
        Path.of(System.getProperty("java.io.tmpdir")),
        NEEDED);
  }

  /**
   * Makes sure that there is a folder with enough room.
   *
   * @return whether there is one
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

  /** The usual folder, or else a new one, which the system empties; empty if there is no room. */
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

  /** Tries it, because quotas do not show in the free space. */
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
