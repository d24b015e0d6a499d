package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.recording.RecordingFile;

/**
 * Where a file of two recordings begins to differ. Immutable; for any thread.
 *
 * @param file its name
 * @param line counted from 1, without video
 * @param time of that line, simulated seconds since the simulation began; empty if it tells none
 * @param recorded the line; empty if there is none
 * @param replayed the line; empty if there is none
 */
public record Difference(
    String file, long line, OptionalDouble time, String recorded, String replayed) {

  /** Files that a simulation decides. */
  private static final List<RecordingFile> FILES =
      List.of(RecordingFile.WIRE, RecordingFile.EVENTS, RecordingFile.FLIGHT, RecordingFile.GOALS);

  /**
   * The first difference of each file of two recordings; none if they are identical, but for what
   * the wall clock decides.
   *
   * @param cutOff whether the first one was cut off, so that the second one may go on
   * @throws IOException if one cannot be read
   */
  static List<Difference> between(Path recorded, Path replayed, boolean cutOff) throws IOException {
    List<Difference> differences = new ArrayList<>();
    for (RecordingFile file :
        cutOff ? FILES.subList(0, FILES.size() - 1) : FILES) { // goals come last
      try (LineFile first = new LineFile(file.in(recorded));
          LineFile second = new LineFile(file.in(replayed))) {
        first(file.fileName(), first, second, cutOff).ifPresent(differences::add);
      }
    }
    return List.copyOf(differences);
  }

  private static Optional<Difference> first(
      String file, LineFile recorded, LineFile replayed, boolean cutOff) throws IOException {
    long line = 0;
    Optional<String> one;
    Optional<String> other;
    do {
      line++;
      one = recorded.next();
      other = replayed.next();
    } while (one.isPresent() && one.equals(other));
    if (one.equals(other) || (one.isEmpty() && cutOff)) {
      return Optional.empty();
    }
    OptionalDouble time = LineFile.time(one.orElse(""));
    OptionalDouble otherTime = LineFile.time(other.orElse(""));
    return Optional.of(
        new Difference(
            file, line, time.isPresent() ? time : otherTime, one.orElse(""), other.orElse("")));
  }
}
