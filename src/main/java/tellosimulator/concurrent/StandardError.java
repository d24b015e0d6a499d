package tellosimulator.concurrent;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;

/**
 * The standard error of the process, bypassing all buffers and the log. It allocates nothing, so
 * that it works when memory is exhausted. Thread-safe.
 */
public final class StandardError {

  private final FileOutputStream stream = new FileOutputStream(FileDescriptor.err);

  /** Writes a line that was created in advance. If standard error is closed, the line is lost. */
  public void write(byte[] line) {
    try {
      stream.write(line);
    } catch (IOException e) {
      // the failure cannot be reported anywhere else
    }
  }
}
