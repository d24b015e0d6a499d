package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The text files of a recording. Each drone's film stands beside them. */
public enum RecordingFile {
  /** What is known of the flight as a whole; makes a folder a recording. */
  RUN("run.json"),
  /** Each datagram, both ways. */
  WIRE("wire.jsonl"),
  /** What happened. */
  EVENTS("events.jsonl"),
  /** Where the drones were. */
  FLIGHT("flight.csv"),
  /** What became of the goals. */
  GOALS("goals.json"),
  /** What the simulation began from, and all that came to it since. */
  INPUTS("inputs.jsonl"),
  /** The scenario as it was flown. */
  SCENARIO("scenario.yaml");

  private static final Pattern FILM = Pattern.compile("(?i)video-[0-9]+\\.mp4");

  private final String fileName;

  RecordingFile(String fileName) {
    this.fileName = fileName;
  }

  public String fileName() {
    return fileName;
  }

  /** Its path in the folder of a recording. */
  public Path in(Path folder) {
    return folder.resolve(fileName);
  }

  /**
   * Whether a path leads to a file that a recording consists of, so that writing to it would damage
   * the recording; links are followed.
   */
  public static boolean belongsToRecording(Path path) {
    Path file = path.toAbsolutePath().normalize();
    try {
      file = file.toRealPath();
    } catch (IOException e) {
      // there is nothing yet
    }
    String name = String.valueOf(file.getFileName());
    boolean reserved =
        FILM.matcher(name).matches()
            || Stream.of(values()).anyMatch(each -> each.fileName.equalsIgnoreCase(name));
    return reserved && file.getParent() != null && Files.exists(RUN.in(file.getParent()));
  }
}
