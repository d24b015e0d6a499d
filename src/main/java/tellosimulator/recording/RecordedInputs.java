package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;

/**
 * The inputs of a recorded flight: first the initial conditions of the simulation, then all inputs
 * until the end of the flight. Inputs are read one at a time, because there may be many. Not
 * thread-safe.
 */
public final class RecordedInputs implements AutoCloseable {

  private final LineReader reader;
  private final InitialConditions start;
  private int damaged;

  /**
   * An input of a simulation. Immutable.
   *
   * @param time the end of the step after which the input was applied
   */
  public record RecordedInput(SimTime time, SimInput input) {

    /**
     * Parses a line.
     *
     * @throws IllegalArgumentException if the line is damaged, or this version does not know the
     *     kind of input
     */
    private static RecordedInput of(String line) {
      Fields fields = Fields.of(line);
      long step =
          fields
              .large("step")
              .filter(each -> each >= 0 && each <= Long.MAX_VALUE / SimTime.STEP_NANOS)
              .orElseThrow(() -> new IllegalArgumentException("step is missing"));
      return new RecordedInput(
          new SimTime(step * SimTime.STEP_NANOS),
          JsonRecords.read(SimInput.class, fields.members().get("input")));
    }
  }

  private RecordedInputs(LineReader reader, InitialConditions start) {
    this.reader = reader;
    this.start = start;
  }

  /**
   * Opens the inputs of a recording.
   *
   * @param folder the recording's folder
   * @return the inputs; empty if they were not recorded, or if this version cannot parse the
   *     initial conditions
   * @throws IOException if the inputs cannot be read
   */
  public static Optional<RecordedInputs> open(Path folder) throws IOException {
    if (!areKept(folder)) {
      return Optional.empty();
    }
    LineReader reader = new LineReader(RecordingFile.INPUTS.in(folder));
    try {
      Optional<String> first = reader.next();
      if (first.isPresent()) {
        return Optional.of(
            new RecordedInputs(reader, InitialConditions.of(Json.value(first.get()))));
      }
    } catch (IllegalArgumentException e) {
      // the line is damaged, or was written by another version
    } catch (IOException e) {
      reader.close();
      throw e;
    }
    reader.close();
    return Optional.empty();
  }

  /** Returns whether a recording contains inputs, even if they cannot be read. */
  public static boolean areKept(Path folder) {
    return RecordingFile.INPUTS.exists(folder);
  }

  /** The initial conditions of the simulation. */
  public InitialConditions start() {
    return start;
  }

  /**
   * Returns the next input; empty after the last one. Damaged lines are skipped.
   *
   * @throws IOException if the file cannot be read
   */
  public Optional<RecordedInput> next() throws IOException {
    for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
      try {
        return Optional.of(RecordedInput.of(line.get()));
      } catch (IllegalArgumentException e) {
        damaged++;
      }
    }
    return Optional.empty();
  }

  /** The number of lines skipped so far. */
  public int damaged() {
    return damaged;
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }
}
