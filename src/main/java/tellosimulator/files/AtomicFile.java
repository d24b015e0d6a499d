package tellosimulator.files;

import static java.nio.file.StandardCopyOption.ATOMIC_MOVE;
import static java.nio.file.StandardCopyOption.REPLACE_EXISTING;
import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.TRUNCATE_EXISTING;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * Replaces a whole file: the new content is written to a file beside it, which then takes its name.
 * Whatever fails before that leaves the file as it was. For any thread.
 */
public final class AtomicFile {

  /** Distinguishes the files that several programs write at the same time. */
  private static final long PROCESS = ProcessHandle.current().pid();

  private AtomicFile() {}

  /** Writes the content of a file. */
  @FunctionalInterface
  public interface Content {

    /**
     * Writes all of it.
     *
     * @param out buffered; closed afterwards
     */
    void write(OutputStream out) throws IOException;
  }

  /**
   * Writes all of a file, or leaves it as it is. A link is followed, and permissions are kept.
   *
   * @throws IOException if the file cannot be written, or from the content
   */
  public static void write(Path file, Content content) throws IOException {
    IrregularFileException.check(file);
    Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw new AccessDeniedException(file.toString());
    }
    if (!Files.isDirectory(target.getParent())) {
      throw new NoSuchFileException(file.toString());
    }
    Path beside = target.resolveSibling("." + target.getFileName() + "." + PROCESS);
    try {
      try (FileChannel channel = FileChannel.open(beside, CREATE, TRUNCATE_EXISTING, WRITE);
          OutputStream out = new BufferedOutputStream(Channels.newOutputStream(channel))) {
        content.write(out);
        out.flush();
        channel.force(true); // or a power cut could leave an empty file under the name
      }
      keepPermissions(target, beside);
      Files.move(beside, target, ATOMIC_MOVE, REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static void keepPermissions(Path from, Path to) throws IOException {
    if (Files.exists(from) && Files.getFileStore(from).supportsFileAttributeView("posix")) {
      Files.setPosixFilePermissions(to, Files.getPosixFilePermissions(from));
    }
  }
}
