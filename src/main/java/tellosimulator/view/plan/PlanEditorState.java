package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;

/**
 * The state of the plan editor, except for the items in the room. It is passed on to the plan of a
 * new window.
 */
public final class PlanEditorState {

  private final UndoStack history;
  private final List<PlanItem> selection;
  private final Optional<PlanViewport> part;

  /**
   * Creates a state.
   *
   * @param part the visible part of the room; empty for the whole room
   */
  PlanEditorState(UndoStack history, List<PlanItem> selection, Optional<PlanViewport> part) {
    this.history = history;
    this.selection = List.copyOf(selection);
    this.part = part;
  }

  UndoStack history() {
    return history;
  }

  List<PlanItem> selection() {
    return selection;
  }

  Optional<PlanViewport> part() {
    return part;
  }
}
