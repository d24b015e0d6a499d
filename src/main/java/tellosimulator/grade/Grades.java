package tellosimulator.grade;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.files.AtomicFile;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Take;

/**
 * The grades of a class. They are written as {@code grades.json}, which can be read again, as
 * {@code grades.csv} with a row for each flight, and as {@code totals.csv} with a row for each
 * hand-in. Immutable.
 *
 * @param assignment the title of the assignment
 * @param take which of several attempts counts
 * @param all the number of hand-ins of the class, of which some may not be graded yet
 * @param titles the title of each course
 * @param handIns the hand-ins, by the names of their folders
 */
public record Grades(
    String assignment,
    Take take,
    Scale scale,
    int all,
    Map<String, String> titles,
    List<GradedHandIn> handIns) {

  public static final String JSON = "grades.json";

  private static final String CSV = "grades.csv";

  private static final String TOTALS = "totals.csv";

  private static final List<Column<Flight>> FLIGHT_COLUMNS =
      List.of(
          new Column<>("hand-in", row -> row.handIn.name()),
          new Column<>("id", row -> row.handIn.id()),
          new Column<>("group", row -> row.handIn.group()),
          new Column<>("course", row -> row.flight.course()),
          new Column<>("seed", row -> row.flight.seed()),
          new Column<>("attempt", row -> row.flight.attempt()),
          new Column<>("verdict", row -> row.result().verdict()),
          new Column<>("program", row -> row.flight.program()),
          new Column<>("goals", row -> row.result().reached()),
          new Column<>("of-goals", row -> row.result().goals().size()),
          new Column<>("seconds", row -> row.result().seconds()),
          new Column<>("touches", row -> row.result().touches()),
          new Column<>("crashes", row -> row.result().crashes()),
          new Column<>("refused", row -> row.result().refused()),
          new Column<>("points", row -> row.result().points()),
          new Column<>("of", row -> row.result().of()),
          new Column<>("time", row -> row.flight.time()),
          new Column<>("wall-seconds", row -> row.flight.wallSeconds()),
          new Column<>("recording", row -> row.flight.recording()));

  private static final List<Column<GradedHandIn>> TOTAL_COLUMNS =
      List.of(
          new Column<>("hand-in", GradedHandIn::name),
          new Column<>("id", GradedHandIn::id),
          new Column<>("group", GradedHandIn::group),
          new Column<>("points", GradedHandIn::points),
          new Column<>("of", GradedHandIn::of),
          new Column<>("percent", GradedHandIn::percent),
          new Column<>("grade", GradedHandIn::grade),
          new Column<>("passed", GradedHandIn::passed));

  /** Beginnings of cells that spreadsheets take for formulas. Documented: OWASP, CSV injection. */
  private static final String FORMULA = "=+-@\t\r";

  /**
   * A column of a table.
   *
   * @param value the value of a row
   */
  private record Column<T>(String name, Function<T, Object> value) {}

  /** A row of the table of flights. */
  private record Flight(GradedHandIn handIn, GradedFlight flight) {

    FlightResult result() {
      return flight.result();
    }
  }

  public Grades {
    titles = Map.copyOf(titles);
    handIns = handIns.stream().sorted(Comparator.comparing(GradedHandIn::folder)).toList();
  }

  /** Creates the grades of a whole class, on courses without titles. */
  public Grades(String assignment, Take take, Scale scale, List<GradedHandIn> handIns) {
    this(assignment, take, scale, handIns.size(), Map.of(), handIns);
  }

  /** Returns a copy with other hand-ins. */
  Grades with(List<GradedHandIn> others) {
    return new Grades(assignment, take, scale, all, titles, others);
  }

  /** Returns the grades of several parts of a class as one. The parts share an assignment. */
  static Grades merged(List<Grades> parts) {
    return parts.get(0).with(parts.stream().flatMap(each -> each.handIns.stream()).toList());
  }

  /** Returns whether all hand-ins of the class are graded. */
  public boolean complete() {
    return handIns.size() >= all;
  }

  /**
   * Reads {@code grades.json}.
   *
   * @param folder the folder of the results
   * @throws IOException if the file cannot be read, or contains something else
   */
  public static Grades read(Path folder) throws IOException {
    Path file = folder.resolve(JSON);
    try {
      return JsonRecords.read(Grades.class, Json.value(Files.readString(file)));
    } catch (IllegalArgumentException e) {
      throw new IOException("it contains no grades: " + e.getMessage(), e);
    }
  }

  /**
   * Writes all files.
   *
   * @param folder the folder of the results, which exists
   * @throws IOException if a file cannot be written
   */
  public void write(Path folder) throws IOException {
    write(folder.resolve(JSON), json());
    Stream<Flight> flights =
        handIns.stream()
            .flatMap(each -> each.flights().stream().map(flight -> new Flight(each, flight)));
    write(folder.resolve(CSV), tableOf(FLIGHT_COLUMNS, flights));
    write(folder.resolve(TOTALS), tableOf(TOTAL_COLUMNS, handIns.stream()));
  }

  private static void write(Path file, String text) throws IOException {
    AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /** Returns the whole as JSON, with a line for each hand-in. */
  private String json() {
    Map<?, ?> all = (Map<?, ?>) JsonRecords.write(Grades.class, this);
    return all.entrySet().stream()
        .map(
            entry ->
                Json.text(entry.getKey())
                    + ": "
                    + (entry.getValue() instanceof List<?> list
                        ? list.stream()
                            .map(Json::text)
                            .collect(Collectors.joining(",\n", "[\n", "\n]"))
                        : Json.text(entry.getValue())))
        .collect(Collectors.joining(",\n", "{", "}\n"));
  }

  private static <T> String tableOf(List<Column<T>> columns, Stream<T> rows) {
    List<Object> names = columns.stream().<Object>map(Column::name).toList();
    return table(
        names, rows.map(row -> columns.stream().map(each -> each.value.apply(row)).toList()));
  }

  /** Returns a table as CSV; no cell is a formula. */
  public static String table(List<Object> columns, Stream<List<Object>> rows) {
    return Stream.concat(Stream.of(columns), rows)
        .map(row -> row.stream().map(Grades::cell).collect(Collectors.joining(",", "", "\r\n")))
        .collect(Collectors.joining());
  }

  /** Returns a cell as RFC 4180 has it. */
  private static String cell(Object value) {
    if (!(value instanceof String text)) {
      return value.toString();
    }
    String safe = !text.isEmpty() && FORMULA.indexOf(text.charAt(0)) >= 0 ? "'" + text : text;
    return safe.matches("[^\",\\r\\n]*") ? safe : "\"" + safe.replace("\"", "\"\"") + "\"";
  }
}
