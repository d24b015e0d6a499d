package tellosimulator.view.log;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javafx.collections.ObservableList;
import tellosimulator.command.Peer;

/**
 * The newest rows of the log, and those of them that pass a filter of level, drone and text. Lines
 * about one command are one row. A line that is added or falls out costs the same however many
 * there are. For the JavaFX thread.
 */
final class LogModel {

  /** Rows that are kept. Decided: an hour of flight with thirty commands a second. */
  static final int CAPACITY = 100_000;

  /** What the lines about a command have in common. */
  private record Key(OptionalInt drone, Peer peer, String command) {

    static Key of(LogLine line, LogLine.Exchange exchange) {
      return new Key(line.drone(), exchange.peer(), exchange.command());
    }
  }

  private final int capacity;
  private final Function<LogRow, String> words;
  private final RingBuffer<LogRow> rows = new RingBuffer<>();

  /** The words of all rows while a text is searched, so that each key typed finds them made. */
  private final RingBuffer<String> searched = new RingBuffer<>();

  /**
   * The rows of commands without an answer, by their numbers, newest last. An answer belongs to the
   * newest: a copy of a command that still runs is refused first.
   */
  private final Map<Key, Deque<Long>> open = new HashMap<>();

  private final ShownRows shown = new ShownRows();
  private LogLevel level = LogLevel.DEBUG;
  private OptionalInt drone = OptionalInt.empty();
  private String text = "";
  private Pattern pattern = Pattern.compile("");
  private long firstRow;
  private long arrived;

  /**
   * @param capacity rows that are kept
   * @param words what is searched of a row
   */
  LogModel(int capacity, Function<LogRow, String> words) {
    this.capacity = capacity;
    this.words = words;
  }

  /** The rows that pass the filter, oldest first. */
  ObservableList<LogRow> shown() {
    return shown.readOnly();
  }

  /** All lines, shown or not, in the order in which they came. */
  List<LogLine> lines() {
    return LogRow.lines(IntStream.range(0, rows.size()).mapToObj(rows::get).toList());
  }

  /** How many rows are kept, shown or not. */
  int size() {
    return rows.size();
  }

  /** A row as it is now; empty if it fell out. */
  Optional<LogRow> row(long number) {
    boolean kept = number >= firstRow && number - firstRow < rows.size();
    return kept ? Optional.of(rows.get(index(number))) : Optional.empty();
  }

  /**
   * Adds lines at the end, or to rows of theirs; the oldest rows fall out if there are too many.
   *
   * @return how many of the rows that were shown fell out
   */
  int append(List<LogLine> added) {
    long firstNew = firstRow + rows.size();
    SortedSet<Long> changed = new TreeSet<>();
    int dropped = 0;
    for (LogLine line : added) {
      changed.add(take(line));
      if (rows.size() > capacity) {
        LogRow oldest = removeFirst();
        if (dropped < shown.size() && shown.get(dropped).number() == oldest.number()) {
          dropped++;
        }
      }
    }
    List<LogRow> passing = new ArrayList<>();
    for (int i = index(Math.max(firstNew, firstRow)); i < rows.size(); i++) {
      if (!text.isEmpty()) {
        searched.addLast(words.apply(rows.get(i)));
      }
      if (passes(i)) {
        passing.add(rows.get(i));
      }
    }
    shown.roll(dropped, passing);
    changed.stream()
        .filter(number -> number >= firstRow && number < firstNew)
        .forEach(this::change);
    return dropped;
  }

  /**
   * Makes a row of a line, or adds it to one.
   *
   * @return the row's number
   */
  private long take(LogLine line) {
    LogRow.Arrival arrival = new LogRow.Arrival(arrived++, line);
    Optional<Key> key = line.exchange().map(exchange -> Key.of(line, exchange));
    boolean begins = line.exchange().filter(LogLine.Exchange::open).isPresent();
    Optional<Long> answered = begins ? Optional.empty() : key.map(open::get).map(Deque::pollLast);
    if (answered.isPresent()) {
      forget(key.get());
      int index = index(answered.get());
      rows.set(index, rows.get(index).with(arrival));
      return answered.get();
    }
    long number = firstRow + rows.size();
    rows.addLast(new LogRow(number, List.of(arrival)));
    if (begins) {
      open.computeIfAbsent(key.get(), none -> new ArrayDeque<>()).addLast(number);
    }
    return number;
  }

  private void forget(Key key) {
    if (open.get(key).isEmpty()) {
      open.remove(key);
    }
  }

  /** Shows a row anew that has more lines than before. */
  private void change(long number) {
    int index = index(number);
    if (!text.isEmpty()) {
      searched.set(index, words.apply(rows.get(index)));
    }
    if (passes(index)) {
      shown.change(rows.get(index));
    }
  }

  void clear() {
    firstRow += rows.size();
    rows.clear();
    searched.clear();
    open.clear();
    shown.replace(new RingBuffer<>());
  }

  /** Shows rows of this level and of those that matter more. */
  void setLevel(LogLevel least) {
    if (least != level) {
      level = least;
      filter();
    }
  }

  /**
   * Shows rows about one drone, and those about all of them.
   *
   * @param wanted its number, from 1; empty for all rows
   */
  void setDrone(OptionalInt wanted) {
    if (!wanted.equals(drone)) {
      drone = wanted;
      filter();
    }
  }

  /**
   * Shows rows that contain a text.
   *
   * @param wanted upper and lower case are the same; empty for all rows
   */
  void setText(String wanted) {
    if (!wanted.equals(text)) {
      text = wanted;
      pattern =
          Pattern.compile(
              wanted, Pattern.LITERAL | Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);
      filter();
    }
  }

  /** The same rows have other words now. */
  void wordsChanged() {
    if (!text.isEmpty()) {
      searched.clear();
      filter();
    }
  }

  private int index(long number) {
    return (int) (number - firstRow);
  }

  private LogRow removeFirst() {
    if (searched.size() > 0) {
      searched.removeFirst();
    }
    firstRow++;
    LogRow oldest = rows.removeFirst();
    LogLine line = oldest.first();
    line.exchange()
        .map(exchange -> Key.of(line, exchange))
        .filter(
            key -> open.containsKey(key) && open.get(key).removeFirstOccurrence(oldest.number()))
        .ifPresent(this::forget);
    return oldest;
  }

  private void filter() {
    prepareSearch();
    RingBuffer<LogRow> passing = new RingBuffer<>();
    for (int i = 0; i < rows.size(); i++) {
      if (passes(i)) {
        passing.addLast(rows.get(i));
      }
    }
    shown.replace(passing);
  }

  private void prepareSearch() {
    if (text.isEmpty()) {
      searched.clear();
      return;
    }
    for (int i = searched.size(); i < rows.size(); i++) {
      searched.addLast(words.apply(rows.get(i)));
    }
  }

  private boolean passes(int index) {
    LogRow row = rows.get(index);
    OptionalInt about = row.first().drone();
    return row.level().reaches(level)
        && (drone.isEmpty() || about.isEmpty() || about.equals(drone))
        && (text.isEmpty() || pattern.matcher(searched.get(index)).find());
  }
}
