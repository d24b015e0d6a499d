package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.recording.RecordingFile;

/**
 * The first difference between the versions of one file in two recordings. Immutable.
 *
 * @param file the file's name
 * @param line the line's number, from 1, not counting video lines
 * @param time the time in that line, in simulated seconds since the simulation began; empty if the
 *     line contains none
 * @param recorded the line in the recording; empty if the recording has fewer lines
 * @param replayed the line in the replay; empty if the replay has fewer lines
 */
public record Difference(
    String file, long line, OptionalDouble time, String recorded, String replayed) {

  /** The files whose contents the simulation determines. */
  private static final List<RecordingFile> FILES =
      List.of(RecordingFile.WIRE, RecordingFile.EVENTS, RecordingFile.FLIGHT, RecordingFile.GOALS);

  /**
   * Returns the first difference in each file of two recordings. The list is empty if the
   * recordings are identical except for the data that depend on the wall clock.
   *
   * @param cutOff whether the first recording was cut off, so that the second one may be longer
   * @throws IOException if a recording cannot be read
   */
  static List<Difference> between(Path recorded, Path replayed, boolean cutOff) throws IOException {
    List<Difference> differences = new ArrayList<>();
    for (RecordingFile file :
        cutOff ? FILES.subList(0, FILES.size() - 1) : FILES) { // all but the goals, the last file
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
