package tellosimulator.fidelity;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;

/**
 * What a program noted of a flight: commands, replies and state lines with their times. Immutable.
 */
record FlightLog(List<Line> lines) {

  private static final String OPERATOR = "192.168.10.2:8889";
  private static final String DRONE = "192.168.10.1:8889";

  /**
   * A datagram.
   *
   * @param seconds on any clock
   * @param kind {@code command}, {@code reply} or {@code state}
   */
  record Line(double seconds, String kind, String text) {}

  FlightLog {
    lines = List.copyOf(lines);
  }

  /**
   * Reads a table with tabs between three columns: seconds, who ({@code CommandAddress}, {@code
   * Tello} or {@code state}), text.
   *
   * @throws IOException if it cannot be read
   * @throws IllegalArgumentException naming the line that is not like that
   */
  static FlightLog read(Path file) throws IOException {
    List<Line> lines = new ArrayList<>();
    for (String row : Files.readAllLines(file)) {
      if (!row.isBlank()) {
        lines.add(line(row, file + ":" + (lines.size() + 1)));
      }
    }
    return new FlightLog(lines);
  }

  private static Line line(String row, String place) {
    String[] cells = row.split("\t", -1);
    if (cells.length != 3 || !cells[0].matches("[0-9]+([.][0-9]+)?")) {
      throw new IllegalArgumentException(
          place + ": expected seconds, who and text with tabs between them, found \"" + row + '"');
    }
    String kind =
        switch (cells[1]) {
          case "Station" -> "command";
          case "Tello" -> "reply";
          case "state" -> "state";
          default ->
              throw new IllegalArgumentException(
                  place + ": expected CommandAddress, Tello or state, found \"" + cells[1] + '"');
        };
    return new Line(Double.parseDouble(cells[0]), kind, cells[2].strip());
  }

  /** The commands, in their order. */
  List<String> commands() {
    return lines.stream().filter(line -> line.kind().equals("command")).map(Line::text).toList();
  }

  /**
   * The same as a recording.
   *
   * @param folder to be made
   */
  Flight recorded(Path folder) throws IOException {
    double begun = lines.isEmpty() ? 0 : lines.get(0).seconds();
    String wire =
        lines.stream()
            .map(line -> Json.text(members(line, begun)))
            .collect(Collectors.joining("\n", "", "\n"));
    new RecordingFixture(folder)
        .run("{\"format\":1,\"started\":0,\"ended\":0}")
        .with("wire.jsonl", wire);
    try {
      return Flight.read(folder);
    } catch (UnreadableRecordingException e) {
      throw new IOException(e);
    }
  }

  private static Map<String, Object> members(Line line, double begun) {
    boolean command = line.kind().equals("command");
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("t", line.seconds() - begun);
    members.put("drone", 1);
    members.put("kind", line.kind());
    members.put("from", command ? OPERATOR : DRONE);
    members.put("to", command ? DRONE : OPERATOR);
    members.put("text", line.text());
    return members;
  }
}
