package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.Pattern;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.collections.transformation.FilteredList;

/**
 * Stores the newest rows of the log, and determines which of them pass a filter for level, drone
 * and text. Lines about one command share a row. Confined to the JavaFX thread.
 */
final class LogModel {

  /**
   * Maximum number of rows. Decided: enough for an hour of flight with almost thirty commands a
   * second.
   */
  static final int CAPACITY = 100_000;

  /** The key that all lines about the same command have in common. */
  private record Key(OptionalInt drone, int command) {

    static Key of(LogLine line, LogLine.Exchange exchange) {
      return new Key(line.drone(), exchange.request().number());
    }
  }

  private final int capacity;
  private final Function<LogRow, String> words;
  private final ObservableList<LogRow> rows = FXCollections.observableArrayList();
  private final FilteredList<LogRow> shown = new FilteredList<>(rows);

  /**
   * The searchable texts of rows during a search, kept so that they are not created again with each
   * keystroke.
   */
  private final IdentityHashMap<LogRow, String> searched = new IdentityHashMap<>();

  /** Maps each command that is still in the log to the number of its row. */
  private final Map<Key, Long> commands = new HashMap<>();

  private LogLevel level = LogLevel.DEBUG;
  private OptionalInt drone = OptionalInt.empty();
  private Optional<Pattern> search = Optional.empty();
  private long firstRow;
  private long arrived;

  /**
   * @param capacity the maximum number of rows
   * @param words returns the searchable text of a row
   */
  LogModel(int capacity, Function<LogRow, String> words) {
    this.capacity = capacity;
    this.words = words;
  }

  /** Returns the rows that pass the filter, oldest first. Unmodifiable. */
  ObservableList<LogRow> shown() {
    return shown;
  }

  /** Returns all lines, whether shown or not, in the order of their arrival. */
  List<LogLine> lines() {
    return LogRow.lines(rows);
  }

  /** Returns the number of rows, whether shown or not. */
  int size() {
    return rows.size();
  }

  /** Returns a row in its current state; empty if it has been removed. */
  Optional<LogRow> row(long number) {
    boolean kept = number >= firstRow && number - firstRow < rows.size();
    return kept ? Optional.of(rows.get(index(number))) : Optional.empty();
  }

  /**
   * Adds each line to the existing row of its command, or as a new row at the end. If there are
   * then too many rows, the oldest ones are removed.
   *
   * @return how many of the removed rows had been shown
   */
  int append(List<LogLine> added) {
    List<LogRow> newRows = new ArrayList<>();
    added.forEach(line -> take(line, newRows));
    rows.addAll(newRows);
    int before = shown.size();
    int surplus = Math.max(0, rows.size() - capacity);
    rows.subList(0, surplus).forEach(this::forget);
    rows.remove(0, surplus);
    firstRow += surplus;
    return before - shown.size();
  }

  /** Adds a line to the existing row of its command, or to a new row. */
  private void take(LogLine line, List<LogRow> newRows) {
    LogRow.Arrival arrival = new LogRow.Arrival(arrived++, line);
    Optional<Key> key = line.exchange().map(exchange -> Key.of(line, exchange));
    boolean begins = line.exchange().filter(exchange -> exchange.outcome().isEmpty()).isPresent();
    Optional<Long> answered = begins ? Optional.empty() : key.map(commands::get);
    if (answered.isPresent()) {
      int index = index(answered.get());
      List<LogRow> owner = index < rows.size() ? rows : newRows;
      int place = index < rows.size() ? index : index - rows.size();
      searched.remove(owner.set(place, owner.get(place).with(arrival)));
      return;
    }
    long number = firstRow + rows.size() + newRows.size();
    newRows.add(new LogRow(number, List.of(arrival)));
    if (begins) {
      commands.put(key.get(), number);
    }
  }

  private void forget(LogRow oldest) {
    searched.remove(oldest);
    LogLine line = oldest.first();
    line.exchange().ifPresent(about -> commands.remove(Key.of(line, about), oldest.number()));
  }

  void clear() {
    firstRow += rows.size();
    rows.clear();
    searched.clear();
    commands.clear();
  }

  /** Shows only rows that are at least as important as this level. */
  void setLevel(LogLevel least) {
    level = least;
    filter();
  }

  /**
   * Shows only rows about one drone and rows about all drones.
   *
   * @param wanted the number of the drone, from 1; empty for all rows
   */
  void setDrone(OptionalInt wanted) {
    drone = wanted;
    filter();
  }

  /**
   * Shows only rows that contain a text.
   *
   * @param wanted the text, ignoring case; empty for all rows
   */
  void setText(String wanted) {
    int flags = Pattern.LITERAL | Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
    search =
        Optional.of(wanted).filter(text -> !text.isEmpty()).map(w -> Pattern.compile(w, flags));
    if (search.isEmpty()) {
      searched.clear();
    }
    filter();
  }

  /** Repeats the search after the words of all rows have changed. */
  void wordsChanged() {
    searched.clear();
    filter();
  }

  private int index(long number) {
    return (int) (number - firstRow);
  }

  private void filter() {
    shown.setPredicate(row -> passes(row));
  }

  private boolean passes(LogRow row) {
    OptionalInt about = row.first().drone();
    return row.level().reaches(level)
        && (drone.isEmpty() || about.isEmpty() || about.equals(drone))
        && search
            .map(pattern -> pattern.matcher(searched.computeIfAbsent(row, words)).find())
            .orElse(true);
  }
}
