package tellosimulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import tellosimulator.json.Json;

/**
 * The files of recordings, read without the project's own reader.
 *
 * @param folder the folder of one recording
 */
public record RecordingFiles(Path folder) {

  /** Returns all recordings in a folder, the oldest first. */
  public static List<RecordingFiles> in(Path parent) throws IOException {
    if (Files.notExists(parent)) {
      return List.of();
    }
    try (Stream<Path> folders = Files.list(parent)) {
      return folders.sorted().map(RecordingFiles::new).toList();
    }
  }

  /** Returns the only recording in a folder. */
  public static RecordingFiles only(Path parent) throws IOException {
    List<RecordingFiles> all = in(parent);
    if (all.size() != 1) {
      throw new AssertionError("there are " + all);
    }
    return all.get(0);
  }

  @SuppressWarnings("unchecked")
  public Map<String, Object> run() throws IOException {
    return (Map<String, Object>) Json.value(text("run.json"));
  }

  @SuppressWarnings("unchecked")
  public List<Map<String, Object>> goals() throws IOException {
    return (List<Map<String, Object>>) Json.value(text("goals.json"));
  }

  /** Returns the lines of a file that contains one JSON object per line. */
  @SuppressWarnings("unchecked")
  public List<Map<String, Object>> objects(String file) throws IOException {
    return text(file).lines().map(line -> (Map<String, Object>) Json.value(line)).toList();
  }

  /** Returns the events of some kinds. */
  public List<Map<String, Object>> events(String... kinds) throws IOException {
    return objects("events.jsonl").stream()
        .filter(event -> List.of(kinds).contains(event.get("kind")))
        .toList();
  }

  /** Returns the datagrams of some kinds. */
  public List<Map<String, Object>> wire(String... kinds) throws IOException {
    return objects("wire.jsonl").stream()
        .filter(datagram -> List.of(kinds).contains(datagram.get("kind")))
        .toList();
  }

  /** Returns the rows of the table without its header; they must not contain quotes. */
  public List<List<String>> rows() throws IOException {
    return text("flight.csv").lines().skip(1).map(row -> List.of(row.split(",", -1))).toList();
  }

  public String text(String file) throws IOException {
    return Files.readString(folder.resolve(file), StandardCharsets.UTF_8);
  }

  public boolean has(String file) {
    return Files.exists(folder.resolve(file));
  }
}
