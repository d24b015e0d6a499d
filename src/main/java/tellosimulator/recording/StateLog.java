package tellosimulator.recording;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The state lines of a recording, which are all that is known of how a real drone moved. */
public final class StateLog {

  private StateLog() {}

  /**
   * Reads the state lines in {@code wire.jsonl}. Lines that are damaged are left out.
   *
   * @param folder of a recording
   * @return in the order in which they were sent; empty if there is no such file
   * @throws IOException if the file cannot be read
   */
  public static List<ReportedState> read(Path folder) throws IOException {
    Path wire = folder.resolve("wire.jsonl");
    List<ReportedState> states = new ArrayList<>();
    if (!Files.isRegularFile(wire)) {
      return states;
    }
    try (BufferedReader reader = Files.newBufferedReader(wire)) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        if (line.contains("\"state\"")) {
          state(line).ifPresent(states::add);
        }
      }
    }
    return states;
  }

  private static Optional<ReportedState> state(String line) {
    try {
      Fields fields = Fields.of(line);
      return fields.text("kind").equals("state")
          ? ReportedState.of(
              fields.numberOr("t", 0), fields.whole("drone").orElse(1), fields.text("text"))
          : Optional.empty();
    } catch (IllegalArgumentException e) { // it was cut off
      return Optional.empty();
    }
  }
}
