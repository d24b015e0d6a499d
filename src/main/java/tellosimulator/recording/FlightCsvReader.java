package tellosimulator.recording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * Reads the rows of {@code flight.csv}, whose columns it finds by their names. For one thread; each
 * recording needs its own.
 */
final class FlightCsvReader {

  /** The largest number that is no damage; times are the largest of all. Decided. */
  private static final double LARGEST = 1e9;

  private final Map<String, Integer> columns = new HashMap<>();
  private final Map<Integer, List<Sample>> samples = new TreeMap<>();
  private final List<String> cells = new ArrayList<>();

  /**
   * @param header the first line
   */
  FlightCsvReader(String header) {
    split(header);
    for (int i = 0; i < cells.size(); i++) {
      columns.put(cells.get(i), i);
    }
  }

  /**
   * Takes the next row.
   *
   * @throws IllegalArgumentException if it has no time, no place, or no number of a drone
   */
  void take(String row) {
    split(row);
    int drone = (int) required("drone");
    if (!RecordedRun.isNumber(drone)) {
      throw new IllegalArgumentException("there is no drone " + drone);
    }
    double time = required("t_s");
    if (!Fields.isMoment(time)) {
      throw new IllegalArgumentException("there is no moment " + time);
    }
    Sample sample =
        new Sample(
            time,
            new Vec3(
                Frames.meters(required("x_cm")),
                Frames.meters(required("y_cm")),
                Frames.meters(required("z_cm"))),
            new Vec3(
                Frames.meters(number("vx_cm_s")),
                Frames.meters(number("vy_cm_s")),
                Frames.meters(number("vz_cm_s"))),
            new Sample.Angles(number("roll_deg"), number("pitch_deg"), number("heading_deg")),
            cell("phase").orElse(""),
            number("battery_pct"),
            cell("command").orElse(""));
    samples.computeIfAbsent(drone, number -> new ArrayList<>()).add(sample);
  }

  /** How each drone moved, in the order of their numbers. */
  List<Track> tracks() {
    return samples.entrySet().stream()
        .map(entry -> new Track(entry.getKey(), entry.getValue()))
        .toList();
  }

  private double required(String column) {
    return cell(column)
        .map(Double::parseDouble)
        .filter(value -> Math.abs(value) <= LARGEST)
        .orElseThrow(() -> new IllegalArgumentException("there is no " + column));
  }

  /** That of a column; 0 if it is empty, too large or not there. */
  private double number(String column) {
    return cell(column)
        .filter(cell -> !cell.isEmpty())
        .map(Double::parseDouble)
        .filter(value -> Math.abs(value) <= LARGEST)
        .orElse(0.0);
  }

  private Optional<String> cell(String column) {
    Integer index = columns.get(column);
    return index == null || index >= cells.size()
        ? Optional.empty()
        : Optional.of(cells.get(index));
  }

  /** Splits a line at its commas; in quotes, a quote is doubled. Source: RFC 4180. */
  private void split(String line) {
    cells.clear();
    int at = 0;
    while (at <= line.length()) {
      boolean quoted = at < line.length() && line.charAt(at) == '"';
      int end = quoted ? closingQuote(line, at + 1) + 1 : at;
      int comma = line.indexOf(',', end);
      int next = comma < 0 ? line.length() : comma;
      cells.add(
          quoted
              ? line.substring(at + 1, Math.max(at + 1, end - 1)).replace("\"\"", "\"")
              : line.substring(at, next));
      at = next + 1;
    }
  }

  private static int closingQuote(String line, int from) {
    int at = from;
    while (at < line.length()) {
      if (line.charAt(at) != '"') {
        at++;
      } else if (at + 1 < line.length() && line.charAt(at + 1) == '"') {
        at += 2;
      } else {
        return at;
      }
    }
    throw new IllegalArgumentException("a quote is not closed");
  }
}
