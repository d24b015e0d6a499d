package tellosimulator.files;

import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** There is something else than a file, such as a pipe, which may block, or a device. */
public final class IrregularFileException extends FileSystemException {

  private static final long serialVersionUID = 1;

  private IrregularFileException(Path path) {
    super(path.toString());
  }

  /**
   * Looks what a path leads to.
   *
   * @throws IrregularFileException if that is there and no regular file
   */
  public static void check(Path path) throws IrregularFileException {
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      throw new IrregularFileException(path);
    }
  }
}
