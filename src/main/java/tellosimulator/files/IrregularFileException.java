package tellosimulator.files;

import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Thrown if a path leads to something other than a regular file: for example to a folder, or to a
 * pipe on which a read may block.
 */
public final class IrregularFileException extends FileSystemException {

  private static final long serialVersionUID = 1;

  private IrregularFileException(Path path) {
    super(path.toString());
  }

  /**
   * Checks that a path leads to a regular file, or that nothing exists there.
   *
   * @throws IrregularFileException if the path leads to anything else
   */
  public static void check(Path path) throws IrregularFileException {
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      throw new IrregularFileException(path);
    }
  }
}
