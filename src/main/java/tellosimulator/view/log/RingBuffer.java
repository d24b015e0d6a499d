package tellosimulator.view.log;

import java.util.Objects;

/** A growing queue with access by index. */
final class RingBuffer<T> {

  private static final int FIRST_ROOM = 1024;

  private T[] items = room(FIRST_ROOM);
  private int first;
  private int size;

  int size() {
    return size;
  }

  T get(int index) {
    Objects.checkIndex(index, size);
    return items[(first + index) % items.length];
  }

  void addLast(T item) {
    if (size == items.length) {
      grow();
    }
    items[(first + size) % items.length] = item;
    size++;
  }

  /** Puts another item in the place of one, which it returns. */
  T set(int index, T item) {
    T before = get(index);
    items[(first + index) % items.length] = item;
    return before;
  }

  /** Puts an item before the one that is there now; cheap near the end. */
  void insert(int index, T item) {
    addLast(item);
    for (int i = size - 1; i > index; i--) {
      set(i, get(i - 1));
    }
    set(index, item);
  }

  T removeFirst() {
    T item = get(0);
    items[first] = null;
    first = (first + 1) % items.length;
    size--;
    return item;
  }

  void clear() {
    items = room(FIRST_ROOM);
    first = 0;
    size = 0;
  }

  private void grow() {
    T[] more = room(2 * items.length);
    System.arraycopy(items, first, more, 0, items.length - first);
    System.arraycopy(items, 0, more, items.length - first, first);
    items = more;
    first = 0;
  }

  @SuppressWarnings("unchecked") // nothing but T is ever put in
  private static <T> T[] room(int size) {
    return (T[]) new Object[size];
  }
}
