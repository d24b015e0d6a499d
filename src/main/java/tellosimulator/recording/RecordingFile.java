package tellosimulator.recording;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tellosimulator.files.IrregularFileException;

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

  /** Largest file that is read whole [bytes]. Decided: 250 drones and a long command line. */
  private static final int LARGEST = 4 << 20;

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

  /** Whether a recording has it, even if it cannot be read. */
  boolean exists(Path folder) {
    return Files.exists(in(folder));
  }

  /**
   * Reads all of it.
   *
   * @throws IOException if it is no text, or larger than any that the program writes
   */
  String read(Path folder) throws IOException {
    Path file = in(folder);
    IrregularFileException.check(file);
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(LARGEST + 1);
      if (bytes.length > LARGEST) {
        throw new IOException("it is larger than " + (LARGEST >> 20) + " MB");
      }
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    }
  }

  /**
   * The folder of a recording that is named by itself or by a file in it.
   *
   * @return the same path if it leads to no such file
   */
  public static Path folderOf(Path place) {
    Path folder = place.toAbsolutePath().getParent();
    boolean inside = Files.isRegularFile(place) && folder != null && RUN.exists(folder);
    return inside ? Optional.ofNullable(place.getParent()).orElse(Path.of(".")) : place;
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
    return reserved && file.getParent() != null && RUN.exists(file.getParent());
  }
}
