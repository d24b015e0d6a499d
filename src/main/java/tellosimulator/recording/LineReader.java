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
 * Reads a text file line by line, so that it may be larger than memory. Text after the last line
 * end is an incomplete line, and is ignored. Not thread-safe.
 */
public final class LineReader implements AutoCloseable {

  /**
   * Maximum length of a line [bytes]. Decided: the first line of the inputs may contain a scenario
   * of the maximum size.
   */
  private static final int LONGEST = 16 << 20;

  private final InputStream in;
  private final byte[] buffer = new byte[1 << 16];
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private int from;
  private int to;

  /**
   * Receives the items of a file, one at a time.
   *
   * @param <T> the type of an item
   */
  @FunctionalInterface
  public interface Sink<T> {

    /**
     * Called for each item.
     *
     * @throws IOException to stop reading
     */
    void accept(T item) throws IOException;
  }

  /**
   * Opens a file; a missing file counts as empty.
   *
   * @throws IOException if it cannot be read, for example because it is a folder or a pipe
   */
  public LineReader(Path file) throws IOException {
    IrregularFileException.check(file);
    in = Files.exists(file) ? Files.newInputStream(file) : InputStream.nullInputStream();
  }

  /**
   * Passes all lines of a file to a sink, one at a time; a missing file counts as empty.
   *
   * @param sink rejects a damaged line with an {@code IllegalArgumentException}
   * @return the number of rejected lines
   * @throws IOException if the file cannot be read
   */
  static int readAll(Path file, Sink<String> sink) throws IOException {
    int refused = 0;
    try (LineReader reader = new LineReader(file)) {
      for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
        try {
          sink.accept(line.get());
        } catch (IllegalArgumentException e) {
          refused++;
        }
      }
    }
    return refused;
  }

  /**
   * Returns the next line without its line end; empty after the last line.
   *
   * @throws IOException if the file cannot be read, or the line is longer than any that the program
   *     writes
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
