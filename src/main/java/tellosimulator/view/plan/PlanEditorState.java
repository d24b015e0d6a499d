package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;

/**
 * What a plan remembers beside what is in the room, for another plan that goes on with it in a
 * window that was opened anew.
 */
public final class PlanEditorState {

  private final UndoStack history;
  private final List<PlanItem> selection;
  private final Optional<PlanViewport> part;

  /**
   * @param part of the room that is shown; empty for all of it
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
