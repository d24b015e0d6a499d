package tellosimulator.wire;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/** Reads the tables: one row per line, cells between bars. */
final class WireTable {

  /** The folder of the tables. */
  static final Path DIRECTORY = Path.of("src/test/resources/wire");

  private static final int CELLS = 8;

  private WireTable() {}

  /**
   * Returns all rows of all tables; a line gives a row for each profile and behaviour that it
   * names.
   */
  static List<WireRow> rows() {
    List<WireRow> rows = new ArrayList<>();
    for (Path file : tables()) {
      List<String> lines = lines(file);
      for (int i = 0; i < lines.size(); i++) {
        if (!lines.get(i).isBlank() && !lines.get(i).startsWith("#")) {
          rows.addAll(row(file.getFileName() + ":" + (i + 1), lines.get(i)));
        }
      }
    }
    return rows;
  }

  /** Returns the lines of a text file; an error names the file. */
  static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read " + file, e);
    }
  }

  /** Returns the texts between bars. */
  static List<String> cells(String line) {
    return Arrays.stream(line.split("\\|", -1)).map(String::strip).toList();
  }

  /** Returns the texts between separators, trimmed, without empty parts. */
  static List<String> parts(String cell, String separator) {
    return Arrays.stream(cell.split(separator, -1))
        .map(String::strip)
        .filter(part -> !part.isEmpty())
        .toList();
  }

  private static List<Path> tables() {
    try (Stream<Path> files = Files.list(DIRECTORY)) {
      return files.filter(file -> file.toString().endsWith(".table")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException("cannot list " + DIRECTORY, e);
    }
  }

  private static List<WireRow> row(String place, String line) {
    List<String> cells = cells(line);
    if (cells.size() != CELLS) {
      throw new IllegalArgumentException(
          place + ": expected " + CELLS + " cells between bars, found " + cells.size());
    }
    List<ExpectedReply> replies =
        cells.get(5).equals("-")
            ? List.of()
            : parts(cells.get(5), "; ").stream()
                .map(part -> ExpectedReply.of(place, part))
                .toList();
    List<WireRow> rows = new ArrayList<>();
    for (Profile profile : chosen(place, cells.get(1), Profile.values())) {
      for (Behavior behavior : chosen(place, cells.get(2), Behavior.values())) {
        rows.add(
            new WireRow(
                place,
                cells.get(0),
                profile,
                behavior,
                parts(cells.get(3), "; "),
                cells.get(4),
                replies,
                parts(cells.get(6), "; "),
                cells.get(7)));
      }
    }
    return rows;
  }

  /** Parses {@code all}, or a list of constants in lower case. */
  private static <T extends Enum<T>> List<T> chosen(String place, String cell, T[] constants) {
    if (cell.equals("all")) {
      return List.of(constants);
    }
    List<String> names = parts(cell, " ");
    List<T> chosen =
        Arrays.stream(constants)
            .filter(constant -> names.contains(constant.name().toLowerCase(Locale.ROOT)))
            .toList();
    if (chosen.isEmpty() || chosen.size() != names.size()) {
      throw new IllegalArgumentException(
          place + ": expected all or some of " + Arrays.toString(constants) + ", found " + cell);
    }
    return chosen;
  }
}
