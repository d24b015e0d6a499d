package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The inputs of a recorded flight: what the simulation began from, and then all that came to it
 * until the flight was over. They are read one after another, since they may be many. For one
 * thread.
 */
public final class RecordedInputs implements AutoCloseable {

  private final LineReader reader;
  private final InitialConditions start;
  private int damaged;

  private RecordedInputs(LineReader reader, InitialConditions start) {
    this.reader = reader;
    this.start = start;
  }

  /**
   * Opens those of a recording.
   *
   * @param folder in which it is
   * @return empty if they are not kept, or this version does not know what they begin from
   * @throws IOException if they cannot be read
   */
  public static Optional<RecordedInputs> open(Path folder) throws IOException {
    if (!areKept(folder)) {
      return Optional.empty();
    }
    LineReader reader = new LineReader(RecordingFile.INPUTS.in(folder));
    try {
      Optional<String> first = reader.next();
      if (first.isPresent()) {
        return Optional.of(new RecordedInputs(reader, InputLines.start(first.get())));
      }
    } catch (IllegalArgumentException e) {
      // it is from another version, or was damaged
    } catch (IOException e) {
      reader.close();
      throw e;
    }
    reader.close();
    return Optional.empty();
  }

  /** Whether a recording has them, even if they cannot be read. */
  public static boolean areKept(Path folder) {
    return RecordingFile.INPUTS.exists(folder);
  }

  /** What the simulation began from. */
  public InitialConditions start() {
    return start;
  }

  /**
   * The next one; empty after the last. Lines that are damaged are left out.
   *
   * @throws IOException if it cannot be read
   */
  public Optional<RecordedInput> next() throws IOException {
    for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
      try {
        return Optional.of(InputLines.input(line.get()));
      } catch (IllegalArgumentException e) {
        damaged++;
      }
    }
    return Optional.empty();
  }

  /** How many lines were left out until now. */
  public int damaged() {
    return damaged;
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }
}
