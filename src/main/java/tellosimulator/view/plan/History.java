package tellosimulator.view.plan;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** What can be undone and done again. */
final class History {

  /** Changes that are remembered. Decided. */
  private static final int MOST = 500;

  private final Deque<Layout> before = new ArrayDeque<>();
  private final Deque<Layout> after = new ArrayDeque<>();

  /** Remembers how it was before a change. */
  void changed(Layout was) {
    before.push(was);
    after.clear();
    if (before.size() > MOST) {
      before.removeLast();
    }
  }

  /**
   * How it was before the last change that is not undone.
   *
   * @param present how it is now
   */
  Optional<Layout> undone(Layout present) {
    return step(before, after, present);
  }

  /**
   * How it was before the last change was undone.
   *
   * @param present how it is now
   */
  Optional<Layout> redone(Layout present) {
    return step(after, before, present);
  }

  private static Optional<Layout> step(Deque<Layout> from, Deque<Layout> to, Layout present) {
    Optional<Layout> wanted = Optional.ofNullable(from.poll());
    wanted.ifPresent(layout -> to.push(present));
    return wanted;
  }

  boolean undoable() {
    return !before.isEmpty();
  }

  boolean redoable() {
    return !after.isEmpty();
  }

  /** Forgets everything. */
  void clear() {
    before.clear();
    after.clear();
  }
}
