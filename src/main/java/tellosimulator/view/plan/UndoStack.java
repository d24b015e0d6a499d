package tellosimulator.view.plan;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** The undo and redo history of floor plans. */
final class UndoStack {

  /** Maximum number of changes in the history. Decided. */
  private static final int MOST = 500;

  private final Deque<FloorPlan> before = new ArrayDeque<>();
  private final Deque<FloorPlan> after = new ArrayDeque<>();

  /** Adds a change to the history, given the plan before the change. */
  void changed(FloorPlan was) {
    before.push(was);
    after.clear();
    if (before.size() > MOST) {
      before.removeLast();
    }
  }

  /** Removes the latest change, because it was not carried out. */
  void drop() {
    before.poll();
  }

  /**
   * Returns the plan before the last change, and remembers the current one for redo.
   *
   * @param present the current plan
   */
  Optional<FloorPlan> undone(FloorPlan present) {
    return step(before, after, present);
  }

  /**
   * Returns the plan before the last undo, and remembers the current one for undo.
   *
   * @param present the current plan
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

  /** Removes the whole history. */
  void clear() {
    before.clear();
    after.clear();
  }
}
