package tellosimulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** A text file of a recording, written some lines at a time. For the writer's thread. */
final class TextFile implements AutoCloseable {

  /** What is written at a time, at the least, in a hurry [characters]. */
  private static final int LARGE = 1 << 16;

  private final OutputStream out;
  private final TextRow row = new TextRow();

  /**
   * Begins it.
   *
   * @throws IOException if it is there already, or cannot be written
   */
  TextFile(Path path, RecordingFolder.Disk disk) throws IOException {
    this.out = disk.create(path);
  }

  /** What is written next; its lines are all ASCII. */
  TextRow row() {
    return row;
  }

  /** Whether many lines wait. */
  boolean isLarge() {
    return row.length() >= LARGE;
  }

  /** Hands all lines to the system, which keeps them if the program is killed. */
  void flush() throws IOException {
    if (row.length() > 0) {
      out.write(row.take().getBytes(StandardCharsets.ISO_8859_1));
      out.flush();
    }
  }

  @Override
  public void close() throws IOException {
    try (out) {
      flush();
    }
  }
}
