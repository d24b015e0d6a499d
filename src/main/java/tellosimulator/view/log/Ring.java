package tellosimulator.view.log;

import java.util.Arrays;
import java.util.Objects;

/** Lines in order, to which new ones are added at the end and old ones taken from the beginning. */
final class LineRing {

  private static final int FIRST_ROOM = 1024;

  private LogLine[] lines = new LogLine[FIRST_ROOM];
  private int first;
  private int size;

  int size() {
    return size;
  }

  LogLine get(int index) {
    Objects.checkIndex(index, size);
    return lines[(first + index) % lines.length];
  }

  void addLast(LogLine line) {
    if (size == lines.length) {
      grow();
    }
    lines[(first + size) % lines.length] = line;
    size++;
  }

  LogLine removeFirst() {
    LogLine line = get(0);
    lines[first] = null;
    first = (first + 1) % lines.length;
    size--;
    return line;
  }

  void clear() {
    lines = new LogLine[FIRST_ROOM];
    first = 0;
    size = 0;
  }

  private void grow() {
    LogLine[] more = Arrays.copyOfRange(lines, first, first + 2 * lines.length);
    System.arraycopy(lines, 0, more, lines.length - first, first);
    lines = more;
    first = 0;
  }
}
