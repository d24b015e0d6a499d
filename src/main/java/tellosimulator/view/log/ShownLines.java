package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.List;
import javafx.collections.ObservableListBase;

/**
 * The lines that pass the filter. Lists that show them are told only what changed: new lines at the
 * end, old ones that fall out at the beginning.
 */
final class ShownLines extends ObservableListBase<LogLine> {

  private Ring<LogLine> lines = new Ring<>();

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
  void replace(Ring<LogLine> others) {
    List<LogLine> before = List.copyOf(this);
    beginChange();
    lines = others;
    nextReplace(0, size(), before);
    endChange();
  }
}
