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

/**
 * The text files of a recording, in the order in which their lines are flushed. The videos of the
 * drones are stored in the same folder.
 */
public enum RecordingFile {
  /** The general data of the flight. A folder that contains this file is a recording. */
  RUN("run.json"),
  /** The initial conditions of the simulation and all of its inputs. */
  INPUTS("inputs.jsonl"),
  /** All datagrams in both directions. */
  WIRE("wire.jsonl"),
  /** The events. */
  EVENTS("events.jsonl"),
  /** The samples of the drones' motion. */
  FLIGHT("flight.csv"),
  /** The results of the goals. */
  GOALS("goals.json"),
  /** The scenario as it was flown. */
  SCENARIO("scenario.yaml");

  /**
   * Largest file that is read as a whole [bytes]. Decided: enough for 250 drones and a long command
   * line.
   */
  private static final int LARGEST = 4 << 20;

  private static final Pattern FILM = Pattern.compile("(?i)video-[0-9]+\\.mp4");

  private final String fileName;

  RecordingFile(String fileName) {
    this.fileName = fileName;
  }

  public String fileName() {
    return fileName;
  }

  /** Returns the path of the file in the folder of a recording. */
  public Path in(Path folder) {
    return folder.resolve(fileName);
  }

  /** Returns whether a recording contains the file, even if it cannot be read. */
  boolean exists(Path folder) {
    return Files.exists(in(folder));
  }

  /**
   * Reads the whole file.
   *
   * @throws IOException if the file is not a text file, or is larger than any that the program
   *     writes
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
   * Returns the folder of a recording.
   *
   * @param place the folder, or a file in it
   * @return the folder; the given path if it is not a file of a recording
   */
  public static Path folderOf(Path place) {
    Path folder = place.toAbsolutePath().getParent();
    boolean inside = Files.isRegularFile(place) && folder != null && RUN.exists(folder);
    return inside ? Optional.ofNullable(place.getParent()).orElse(Path.of(".")) : place;
  }

  /**
   * Returns whether a path leads to a file of a recording. Writing to such a file would damage the
   * recording. Links are followed.
   */
  public static boolean belongsToRecording(Path path) {
    Path file = path.toAbsolutePath().normalize();
    try {
      file = file.toRealPath();
    } catch (IOException e) {
      // the file does not exist yet
    }
    String name = String.valueOf(file.getFileName());
    boolean reserved =
        FILM.matcher(name).matches()
            || Stream.of(values()).anyMatch(each -> each.fileName.equalsIgnoreCase(name));
    return reserved && file.getParent() != null && RUN.exists(file.getParent());
  }
}
