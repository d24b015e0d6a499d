package tellosimulator.view.plan;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** Undo and redo history of floor plans. */
final class UndoStack {

  /** Changes that are remembered. Decided. */
  private static final int MOST = 500;

  private final Deque<FloorPlan> before = new ArrayDeque<>();
  private final Deque<FloorPlan> after = new ArrayDeque<>();

  /** Remembers how it was before a change. */
  void changed(FloorPlan was) {
    before.push(was);
    after.clear();
    if (before.size() > MOST) {
      before.removeLast();
    }
  }

  /** Forgets the change that was remembered last, as it was not carried out. */
  void drop() {
    before.poll();
  }

  /**
   * How it was before the last change that is not undone.
   *
   * @param present how it is now
   */
  Optional<FloorPlan> undone(FloorPlan present) {
    return step(before, after, present);
  }

  /**
   * How it was before the last change was undone.
   *
   * @param present how it is now
   */
  Optional<FloorPlan> redone(FloorPlan present) {
    return step(after, before, present);
  }

  private static Optional<FloorPlan> step(
      Deque<FloorPlan> from, Deque<FloorPlan> to, FloorPlan present) {
    Optional<FloorPlan> wanted = Optional.ofNullable(from.poll());
    wanted.ifPresent(plan -> to.push(present));
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
