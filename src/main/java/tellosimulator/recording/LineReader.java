package tellosimulator.recording;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.files.IrregularFileException;

/**
 * Reads a text file that may be longer than memory, line by line. What comes after the last end of
 * a line was cut off and is left out. For one thread.
 */
public final class LineReader implements AutoCloseable {

  /** Longest line [bytes]. Decided: a scenario of the largest size, as the first input tells it. */
  private static final int LONGEST = 16 << 20;

  private final InputStream in;
  private final byte[] buffer = new byte[1 << 16];
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private int from;
  private int to;

  /**
   * Opens a file; one that is missing has no lines.
   *
   * @throws IOException if it cannot be read, such as a folder or a pipe
   */
  public LineReader(Path file) throws IOException {
    IrregularFileException.check(file);
    in = Files.exists(file) ? Files.newInputStream(file) : InputStream.nullInputStream();
  }

  /**
   * The next line, without its end; empty after the last.
   *
   * @throws IOException if it cannot be read, or is longer than any that the program writes
   */
  public Optional<String> next() throws IOException {
    line.reset();
    while (to >= 0) {
      for (int i = from; i < to; i++) {
        if (buffer[i] == '\n') {
          line.write(buffer, from, i - from);
          from = i + 1;
          return Optional.of(line.toString(StandardCharsets.UTF_8));
        }
      }
      line.write(buffer, from, to - from);
      if (line.size() > LONGEST) {
        throw new IOException("a line of it is longer than " + (LONGEST >> 20) + " MB");
      }
      from = 0;
      to = in.read(buffer);
    }
    return Optional.empty();
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
