package tellosimulator.replay;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.files.IrregularFileException;
import tellosimulator.recording.LineReader;

/**
 * The lines of a recording's file that a simulation decides: without what the wall clock says, and
 * without video, which follows that clock. For one thread.
 */
final class LineFile implements AutoCloseable {

  /** Of video, whose digest tells nothing about a simulation. */
  private static final String VIDEO = "\"kind\":\"video\"";

  /** The wall clock of a line of {@code wire.jsonl}, which comes second. */
  private static final Pattern WALL = Pattern.compile("^(\\{\"t\":[0-9.]+),\"wall\":-?[0-9]+");

  /** The moment at which a line begins, in JSON and in CSV [s]. */
  private static final Pattern TIME = Pattern.compile("^(?:\\{\"t\":)?([0-9]{1,9}\\.[0-9]{3}),");

  /** In which the last moment of a file is looked for [bytes]. Decided: some hundred lines. */
  private static final int TAIL = 1 << 16;

  private final LineReader lines;

  /**
   * Opens it; one that is missing has no lines.
   *
   * @throws IOException if it cannot be read
   */
  LineFile(Path file) throws IOException {
    lines = new LineReader(file);
  }

  /** The next line; empty after the last. */
  Optional<String> next() throws IOException {
    Optional<String> next = lines.next();
    while (next.isPresent() && next.get().contains(VIDEO)) {
      next = lines.next();
    }
    return next.map(text -> WALL.matcher(text).replaceFirst("$1"));
  }

  /** The moment that a line tells of [s]; empty if it tells of none. */
  static OptionalDouble time(String line) {
    Matcher matcher = TIME.matcher(line);
    return matcher.find()
        ? OptionalDouble.of(Double.parseDouble(matcher.group(1)))
        : OptionalDouble.empty();
  }

  /** The last moment that a file tells of, near its end [s]; 0 if it tells of none. */
  static double lastTime(Path file) throws IOException {
    IrregularFileException.check(file);
    if (!Files.exists(file)) {
      return 0;
    }
    String tail;
    try (InputStream in = Files.newInputStream(file)) {
      in.skipNBytes(Math.max(0, Files.size(file) - TAIL));
      tail = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
    }
    double last = 0;
    for (String line : tail.split("\n", -1)) {
      last = time(line).orElse(last);
    }
    return last;
  }

  @Override
  public void close() throws IOException {
    lines.close();
  }
}
