package tellosimulator.concurrent;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;

/**
 * The process's standard error, past all buffers and the log: takes no memory, so it works where
 * there is none left. For any thread.
 */
public final class StandardError {

  private final FileOutputStream stream = new FileOutputStream(FileDescriptor.err);

  /** Writes a line that was made beforehand, and loses it if standard error is closed. */
  public void write(byte[] line) {
    try {
      stream.write(line);
    } catch (IOException e) {
      // nobody is left to be told
    }
  }
}
