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
 * Reads the lines of a recording's file, reduced to what the simulation determines. Wall-clock
 * times are removed from the lines. Video lines are left out, because video follows the wall clock.
 * Not thread-safe.
 */
final class LineFile implements AutoCloseable {

  /** The text that identifies a video line. */
  private static final String VIDEO = "\"kind\": \"video\"";

  /** The wall-clock time in a line of {@code wire.jsonl}: the second member of the object. */
  private static final Pattern WALL = Pattern.compile("^(\\{\"t\": [0-9.]+), \"wall\": -?[0-9]+");

  /** The time at the start of a line, in JSON and in CSV [s]. */
  private static final Pattern TIME = Pattern.compile("^(?:\\{\"t\": )?([0-9]{1,9}\\.[0-9]{1,3}),");

  /**
   * Length of the tail of a file that is searched for the last timestamp [bytes]. Decided: this
   * holds several hundred lines.
   */
  private static final int TAIL = 1 << 16;

  private final LineReader lines;

  /**
   * Opens a file; a missing file counts as empty.
   *
   * @throws IOException if it cannot be read
   */
  LineFile(Path file) throws IOException {
    lines = new LineReader(file);
  }

  /** Returns the next line; empty after the last one. */
  Optional<String> next() throws IOException {
    Optional<String> next = lines.next();
    while (next.isPresent() && next.get().contains(VIDEO)) {
      next = lines.next();
    }
    return next.map(text -> WALL.matcher(text).replaceFirst("$1"));
  }

  /** Returns the time in a line [s]; empty if the line contains none. */
  static OptionalDouble time(String line) {
    Matcher matcher = TIME.matcher(line);
    return matcher.find()
        ? OptionalDouble.of(Double.parseDouble(matcher.group(1)))
        : OptionalDouble.empty();
  }

  /** Returns the last timestamp near the end of a file [s]; 0 if none is found. */
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
