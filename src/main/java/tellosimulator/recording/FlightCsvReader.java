package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * Reads the rows of {@code flight.csv}; columns are found by name. Not thread-safe; each recording
 * needs its own instance.
 */
public final class FlightCsvReader {

  /**
   * The largest magnitude of an undamaged number. Decided: ten times the latest time, because times
   * are the largest numbers in a row.
   */
  private static final double LARGEST = 1e9;

  private final Map<String, Integer> columns = new HashMap<>();
  private final List<String> cells = new ArrayList<>();

  private final SampleConsumer consumer;

  /** Receives the samples of all rows. */
  @FunctionalInterface
  public interface SampleConsumer {

    /**
     * Called for each sample.
     *
     * @param drone the drone's number, from 1
     * @throws IOException to stop reading
     */
    void accept(int drone, Sample sample) throws IOException;
  }

  private FlightCsvReader(String header, SampleConsumer consumer) {
    this.consumer = consumer;
    split(header);
    for (int i = 0; i < cells.size(); i++) {
      columns.put(cells.get(i), i);
    }
  }

  /**
   * Passes all rows of a recording to a consumer one at a time, because they may not fit into
   * memory.
   *
   * @param folder the folder of a recording; if it contains no table, there are no rows
   * @return the number of damaged rows, which are skipped
   * @throws IOException if the rows cannot be read
   */
  public static int readAll(Path folder, SampleConsumer consumer) throws IOException {
    FlightCsvReader[] table = new FlightCsvReader[1];
    return LineReader.readAll(
        RecordingFile.FLIGHT.in(folder),
        line -> {
          if (table[0] == null) {
            table[0] = new FlightCsvReader(line, consumer);
          } else {
            table[0].take(line);
          }
        });
  }

  /**
   * Parses the next row.
   *
   * @throws IllegalArgumentException if it lacks a time, a position or a drone number
   */
  private void take(String row) throws IOException {
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
    consumer.accept(drone, sample);
  }

  private double required(String column) {
    return cell(column)
        .map(Double::parseDouble)
        .filter(value -> Math.abs(value) <= LARGEST)
        .orElseThrow(() -> new IllegalArgumentException("there is no " + column));
  }

  /** Returns the number in a column; 0 if it is missing, empty or too large. */
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

  /**
   * Splits a line at its commas, except inside quotes; within quoted cells, quotes are doubled.
   * Documented: RFC 4180.
   */
  private void split(String line) {
    cells.clear();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i <= line.length(); i++) {
      char c = i < line.length() ? line.charAt(i) : ',';
      if (c == '"') {
        quoted = !quoted; // a doubled quote toggles this twice
        cell.append(quoted && i > 0 && line.charAt(i - 1) == '"' ? "\"" : "");
      } else if (c == ',' && !quoted) {
        cells.add(cell.toString());
        cell.setLength(0);
      } else {
        cell.append(c);
      }
    }
    if (quoted) {
      throw new IllegalArgumentException("a quote is not closed");
    }
  }
}
