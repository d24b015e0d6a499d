package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.List;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.collections.ObservableListBase;

/**
 * The rows of the log that pass its filter, by their numbers. Lists that show them are told only
 * what changed: new rows at the end, old ones that fall out at the beginning, and rows with more
 * lines than before. For the JavaFX thread.
 */
final class ShownRows extends ObservableListBase<LogRow> {

  private final ObservableList<LogRow> readOnly = FXCollections.unmodifiableObservableList(this);
  private RingBuffer<LogRow> rows = new RingBuffer<>();

  /** The same rows for those who only show them. */
  ObservableList<LogRow> readOnly() {
    return readOnly;
  }

  @Override
  public LogRow get(int index) {
    return rows.get(index);
  }

  @Override
  public int size() {
    return rows.size();
  }

  /** Drops those at the beginning and adds others at the end, as one change. */
  void roll(int dropped, List<LogRow> added) {
    beginChange();
    if (dropped > 0) {
      List<LogRow> removed = new ArrayList<>(dropped);
      for (int i = 0; i < dropped; i++) {
        removed.add(rows.removeFirst());
      }
      nextRemove(0, removed);
    }
    if (!added.isEmpty()) {
      int before = size();
      added.forEach(rows::addLast);
      nextAdd(before, size());
    }
    endChange();
  }

  /** Shows a row in the place of the one with its number, or for the first time. */
  void change(LogRow row) {
    int place = place(row.number());
    beginChange();
    if (place < size() && get(place).number() == row.number()) {
      nextSet(place, rows.set(place, row));
    } else {
      rows.insert(place, row);
      nextAdd(place, place + 1);
    }
    endChange();
  }

  /** Shows other rows. */
  void replace(RingBuffer<LogRow> others) {
    List<LogRow> before = List.copyOf(this);
    beginChange();
    rows = others;
    nextReplace(0, size(), before);
    endChange();
  }

  /** Index of the first row that has this number or a higher one. */
  private int place(long number) {
    int low = 0;
    int high = size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (get(middle).number() < number) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
