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
 * Replaces a whole file. The new content is written to a temporary file in the same folder, and the
 * temporary file is then renamed. If any step before the renaming fails, the original file is
 * unchanged. Thread-safe, but two threads must not write the same file at the same time.
 */
public final class AtomicFile {

  /**
   * The process id. It is part of the names of temporary files, so that two processes that write
   * the same file at the same time use different names.
   */
  private static final long PROCESS = ProcessHandle.current().pid();

  private AtomicFile() {}

  /** Writes the content of a file. */
  @FunctionalInterface
  public interface Content {

    /**
     * Writes the whole content.
     *
     * @param out a buffered stream; the caller closes it afterwards
     */
    void write(OutputStream out) throws IOException;
  }

  /**
   * Writes the whole file, or leaves it unchanged. Follows links and keeps permissions.
   *
   * @throws IOException if the file cannot be written, or if {@code content} throws one
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
        channel.force(true); // otherwise, a power failure could leave an empty file
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
