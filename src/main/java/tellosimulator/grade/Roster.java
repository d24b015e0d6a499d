package tellosimulator.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Reads the students of a class from a CSV file with the columns name, id and group, of which the
 * last two may be missing; a heading may give them in another order. Cells are separated by
 * semicolons if the first line has one. Thread-safe.
 */
final class Roster {

  private static final List<String> COLUMNS = List.of("name", "id", "group");

  private Roster() {}

  /** A row of a roster. */
  record Student(String name, String id, String group) {}

  /**
   * Reads a roster.
   *
   * @throws IOException if the file cannot be read, or has an unknown column; the message is a
   *     clause
   */
  static List<Student> read(Path file) throws IOException {
    List<List<String>> rows = rows(Files.readString(file).replace("\uFEFF", ""));
    List<String> first =
        rows.isEmpty()
            ? List.of()
            : rows.get(0).stream().map(cell -> cell.toLowerCase(Locale.ROOT)).toList();
    boolean heading = first.contains("name");
    List<String> columns = heading ? first : COLUMNS;
    for (String column : columns) {
      if (!COLUMNS.contains(column)) {
        throw new IOException(
            file + " has the column \"" + column + "\": expected name, id and group");
      }
    }
    List<Student> students = new ArrayList<>();
    for (List<String> row : rows.subList(heading ? 1 : 0, rows.size())) {
      List<String> cells =
          COLUMNS.stream()
              .map(columns::indexOf)
              .map(i -> i >= 0 && i < row.size() ? row.get(i) : "")
              .toList();
      if (!cells.get(0).isEmpty()) {
        students.add(new Student(cells.get(0), cells.get(1), cells.get(2)));
      }
    }
    return students;
  }

  /** Returns the cells of a table. Documented: RFC 4180. */
  private static List<List<String>> rows(String text) {
    char separator = text.lines().findFirst().orElse("").contains(";") ? ';' : ',';
    List<List<String>> rows = new ArrayList<>();
    List<String> row = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false; // whether the cell began with a quotation mark
    boolean within = false;
    char before = separator;
    for (char c : (text + "\n").toCharArray()) {
      if (c == '"' && (quoted || cell.toString().isBlank())) {
        if (quoted && !within && before == '"') {
          cell.append(c); // two of them are one
        }
        quoted = true;
        within = !within;
      } else if (!within && (c == separator || c == '\n')) {
        row.add(cell.toString().strip());
        cell.setLength(0);
        quoted = false;
        if (c == '\n') {
          rows.add(row);
          row = new ArrayList<>();
        }
      } else {
        cell.append(c);
      }
      before = c;
    }
    return rows;
  }
}
