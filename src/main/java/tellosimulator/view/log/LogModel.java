package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.collections.ObservableListBase;

/**
 * The newest lines of the log, and those of them that pass a filter of level and text. A line that
 * is added or falls out costs the same however many there are. For the JavaFX thread.
 */
final class LogModel {

  /** Lines that are kept. Decided: an hour of flight with thirty commands a second. */
  static final int CAPACITY = 100_000;

  private final int capacity;
  private final Function<LogLine, String> words;
  private final RingBuffer<LogLine> lines = new RingBuffer<>();

  /** The words of all lines while a text is searched, so that each key typed finds them made. */
  private final RingBuffer<String> searched = new RingBuffer<>();

  private final ShownLines shown = new ShownLines();
  private final ObservableList<LogLine> readOnly = FXCollections.unmodifiableObservableList(shown);
  private LogLevel level = LogLevel.DEBUG;
  private String text = "";
  private Pattern pattern = Pattern.compile("");

  /**
   * @param capacity lines that are kept
   * @param words what is searched of a line
   */
  LogModel(int capacity, Function<LogLine, String> words) {
    this.capacity = capacity;
    this.words = words;
  }

  /** The lines that pass the filter, oldest first. */
  ObservableList<LogLine> shown() {
    return readOnly;
  }

  /** All lines, shown or not, oldest first. */
  List<LogLine> lines() {
    return IntStream.range(0, lines.size()).mapToObj(lines::get).toList();
  }

  /** How many lines are kept, shown or not. */
  int size() {
    return lines.size();
  }

  /**
   * Adds lines at the end; the oldest fall out if there are too many.
   *
   * @return how many of the lines that were shown fell out
   */
  int append(List<LogLine> added) {
    List<LogLine> kept = added.subList(Math.max(0, added.size() - capacity), added.size());
    int dropped = 0;
    while (lines.size() + kept.size() > capacity) {
      LogLine oldest = removeFirst();
      if (dropped < shown.size() && shown.get(dropped).equals(oldest)) {
        dropped++;
      }
    }
    List<LogLine> passing = new ArrayList<>();
    for (LogLine line : kept) {
      lines.addLast(line);
      if (!text.isEmpty()) {
        searched.addLast(words.apply(line));
      }
      if (passes(lines.size() - 1)) {
        passing.add(line);
      }
    }
    shown.roll(dropped, passing);
    return dropped;
  }

  void clear() {
    lines.clear();
    searched.clear();
    shown.replace(new RingBuffer<>());
  }

  /** Shows lines of this level and of those that matter more. */
  void setLevel(LogLevel least) {
    if (least != level) {
      level = least;
      filter();
    }
  }

  /**
   * Shows lines that contain a text.
   *
   * @param wanted upper and lower case are the same; empty for all lines
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

  /** The same lines have other words now. */
  void wordsChanged() {
    if (!text.isEmpty()) {
      searched.clear();
      filter();
    }
  }

  private LogLine removeFirst() {
    if (searched.size() > 0) {
      searched.removeFirst();
    }
    return lines.removeFirst();
  }

  private void filter() {
    prepareSearch();
    RingBuffer<LogLine> passing = new RingBuffer<>();
    for (int i = 0; i < lines.size(); i++) {
      if (passes(i)) {
        passing.addLast(lines.get(i));
      }
    }
    shown.replace(passing);
  }

  private void prepareSearch() {
    if (text.isEmpty()) {
      searched.clear();
      return;
    }
    for (int i = searched.size(); i < lines.size(); i++) {
      searched.addLast(words.apply(lines.get(i)));
    }
  }

  private boolean passes(int index) {
    return lines.get(index).level().reaches(level)
        && (text.isEmpty() || pattern.matcher(searched.get(index)).find());
  }

  /**
   * The lines that pass the filter. Lists that show them are told only what changed: new lines at
   * the end, old ones that fall out at the beginning.
   */
  private static final class ShownLines extends ObservableListBase<LogLine> {

    private RingBuffer<LogLine> lines = new RingBuffer<>();

    @Override
    public LogLine get(int index) {
      return lines.get(index);
    }

    @Override
    public int size() {
      return lines.size();
    }

    /** Drops those at the beginning and adds others at the end, as one change. */
    void roll(int dropped, List<LogLine> added) {
      beginChange();
      if (dropped > 0) {
        List<LogLine> removed = new ArrayList<>(dropped);
        for (int i = 0; i < dropped; i++) {
          removed.add(lines.removeFirst());
        }
        nextRemove(0, removed);
      }
      if (!added.isEmpty()) {
        int before = size();
        added.forEach(lines::addLast);
        nextAdd(before, size());
      }
      endChange();
    }

    /** Shows other lines. */
    void replace(RingBuffer<LogLine> others) {
      List<LogLine> before = List.copyOf(this);
      beginChange();
      lines = others;
      nextReplace(0, size(), before);
      endChange();
    }
  }
}
