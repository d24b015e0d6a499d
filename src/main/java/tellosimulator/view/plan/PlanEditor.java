package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.goal.Challenge;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.Start;

/**
 * The state of the editor: the placed items, the selection, and the undo history. Each change is
 * sent to the simulation at once, unless an item would not fit. Confined to the JavaFX thread.
 */
final class PlanEditor {

  private final SimulatorActions actions;
  private final FxSimulation simulation;
  private final FxScenario scenario;
  private final ReadOnlyObjectWrapper<FloorPlan> plan;
  private final ReadOnlyObjectWrapper<List<PlanItem>> selection =
      new ReadOnlyObjectWrapper<>(this, "selection", List.of());
  private final ReadOnlyObjectWrapper<Optional<PlacementProblem>> problem =
      new ReadOnlyObjectWrapper<>(this, "problem", Optional.empty());
  private final ReadOnlyBooleanWrapper undoable = new ReadOnlyBooleanWrapper(this, "undoable");
  private final ReadOnlyBooleanWrapper redoable = new ReadOnlyBooleanWrapper(this, "redoable");
  private UndoStack history = new UndoStack();

  /** The plan before the current drag; empty if there is none. */
  private Optional<FloorPlan> held = Optional.empty();

  PlanEditor(FxSimulation simulation, SimulatorActions actions, FxScenario scenario) {
    this.simulation = simulation;
    this.scenario = scenario;
    this.actions = actions;
    this.plan = new ReadOnlyObjectWrapper<>(present(scenario.challenge()));
  }

  private FloorPlan present(Challenge challenge) {
    return FloorPlan.of(simulation.snapshot(), scenario.origins(), challenge);
  }

  /** Adopts the newest snapshot. Must be called once per UI tick while the plan is shown. */
  void advance() {
    if (actions.pending()) {
      return; // the snapshot does not include the change yet
    }
    FloorPlan before = plan.get();
    FloorPlan newest = present(held.isPresent() ? before.challenge() : scenario.challenge());
    if (newest.equals(before)) {
      return;
    }
    if (!newest.arena().room().equals(before.arena().room())) {
      forget(); // items of the old room may be outside the new one
    }
    show(newest);
  }

  /** Returns the undo history, so that it can be passed to the editor of another window. */
  UndoStack history() {
    return history;
  }

  /** Restores the history and selection from another window. */
  void goOn(UndoStack done, List<PlanItem> selected) {
    history = done;
    select(selected.stream().filter(plan()::has).toList());
    showHistory();
  }

  /** The placed items. */
  ReadOnlyObjectProperty<FloorPlan> planProperty() {
    return plan.getReadOnlyProperty();
  }

  FloorPlan plan() {
    return plan.get();
  }

  /**
   * The items that mouse and keyboard input affects. The item that was selected last is at the end.
   */
  ReadOnlyObjectProperty<List<PlanItem>> selectionProperty() {
    return selection.getReadOnlyProperty();
  }

  List<PlanItem> selection() {
    return selection.get();
  }

  /** Returns the item that was selected last; empty if there is none. */
  Optional<PlanItem> selected() {
    List<PlanItem> all = selection();
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(all.size() - 1));
  }

  /** Selects only these items. */
  void select(List<PlanItem> items) {
    selection.set(List.copyOf(items));
  }

  /** Adds an item to the selection, or removes it. */
  void toggle(PlanItem item) {
    List<PlanItem> items = new ArrayList<>(selection());
    if (!items.remove(item)) {
      items.add(item);
    }
    select(items);
  }

  /** The reason why the last change was refused; empty if it was not refused. */
  ReadOnlyObjectProperty<Optional<PlacementProblem>> problemProperty() {
    return problem.getReadOnlyProperty();
  }

  ReadOnlyBooleanProperty undoableProperty() {
    return undoable.getReadOnlyProperty();
  }

  ReadOnlyBooleanProperty redoableProperty() {
    return redoable.getReadOnlyProperty();
  }

  /** Begins a change that consists of several moves and is undone as a whole. */
  void hold() {
    held = Optional.of(plan());
  }

  /** Ends a change that began with {@link #hold}. */
  void release() {
    Optional<FloorPlan> was = held;
    held = Optional.empty();
    was.filter(before -> !before.equals(plan()))
        .ifPresent(
            before -> {
              remember(before);
              ask(plan().challenge());
            });
    problem.set(Optional.empty());
  }

  /**
   * Changes the placement of the item that was selected last, and moves the other selected items by
   * the same distance. If one of them does not fit, moves none of them and sets the problem.
   */
  void place(UnaryOperator<Placement> change) {
    selected().ifPresent(item -> place(item, change.apply(plan().placement(item))));
  }

  private void place(PlanItem item, Placement placement) {
    Vec3 way = placement.place().minus(plan().placement(item).place());
    FloorPlan wanted = placed(item, placement);
    for (PlanItem other : selection().subList(0, selection().size() - 1)) {
      Placement beside = plan().placement(other);
      wanted = wanted.with(other, beside.at(beside.place().plus(way)));
    }
    tryOut(wanted);
  }

  /**
   * Moves an item in the plan. If a goal that names a gate or pad is moved alone, it is assigned to
   * the gate or pad nearest to its new place.
   */
  private FloorPlan placed(PlanItem item, Placement placement) {
    return selection().size() == 1 && item instanceof GoalItem goal && plan().namesAnother(goal)
        ? plan().with(goal, GoalPlacement.renamed(plan().goal(goal), placement.place(), plan()))
        : plan().with(item, placement);
  }

  /** Aligns the selected items with an edge or the middle of the item that was selected last. */
  void align(Alignment alignment) {
    tryOut(alignment.aligned(plan(), selection()));
  }

  /** Returns whether a selected item can be removed; one drone must remain. */
  boolean removable() {
    long starts = selection().stream().filter(Start.class::isInstance).count();
    return !selection().isEmpty()
        && (selection().size() > starts || starts < plan().drones().size());
  }

  /** Removes the selected items, or sets the problem if that is not possible. */
  void remove() {
    List<PlanItem> drones = selection().stream().filter(Start.class::isInstance).toList();
    List<PlanItem> others = new ArrayList<>(selection());
    others.removeAll(drones);
    FloorPlan rest = plan().without(others);
    problem.set(
        PlacementProblem.problemWithGoals(plan(), rest)
            .or(() -> PlacementProblem.problemWithout(rest, drones, faultNamesDrone())));
    if (problem.get().isEmpty()) {
      carryOut(rest.without(drones), List.of());
    }
  }

  /** Returns whether a fault names a drone by its number, so that drones must not be renumbered. */
  private boolean faultNamesDrone() {
    return scenario.scenario().config().rules().faults().faults().stream()
        .anyMatch(fault -> fault.target().drone().isPresent());
  }

  /** Undoes the last change. */
  void undo() {
    history
        .undone(plan())
        .filter(wanted -> !restored(wanted))
        .ifPresent(wanted -> history.redone(wanted)); // it was refused: restores the history
  }

  /** Repeats the change that was undone last. */
  void redo() {
    history
        .redone(plan())
        .filter(wanted -> !restored(wanted))
        .ifPresent(wanted -> history.undone(wanted)); // it was refused: restores the history
  }

  private boolean restored(FloorPlan earlier) {
    held = Optional.empty();
    FloorPlan wanted = earlier.in(plan().arena());
    problem.set(refusal(wanted));
    boolean done = problem.get().isEmpty() && send(wanted);
    showHistory();
    return done;
  }

  /**
   * Carries out a change of the selected items, or sets the problem if one of them does not fit.
   */
  void tryOut(FloorPlan wanted) {
    problem.set(
        selection().stream()
            .flatMap(item -> PlacementProblem.problem(wanted, item).stream())
            .findFirst());
    if (problem.get().isEmpty()) {
      carryOut(wanted);
    }
  }

  void carryOut(FloorPlan wanted) {
    carryOut(wanted, selection());
  }

  /**
   * Carries out a change of the item that was selected last. Sets the problem instead if another
   * obstacle already has the new name, if the gate or pad that a goal names would disappear, or if
   * drones would be renumbered although a fault names one.
   */
  void change(PlanChange change) {
    FloorPlan wanted = change.plan();
    boolean renumbered = !selected().equals(Optional.of(change.item()));
    if (wanted.names().size() < plan().names().size()) {
      refuse(PlacementProblem.NAME_TAKEN);
    } else if (renumbered && change.item() instanceof Start && faultNamesDrone()) {
      refuse(PlacementProblem.NAMED_BY_FAULT);
    } else {
      PlacementProblem.problemWithGoals(plan(), wanted)
          .ifPresentOrElse(
              this::refuse,
              () -> carryOut(wanted, renumbered ? List.of(change.item()) : selection()));
    }
  }

  /** Sets the reason why a change was refused. */
  void refuse(PlacementProblem why) {
    problem.set(Optional.of(why));
  }

  /**
   * Selects items, then applies a change to them. The order matters, because another window may
   * take over during the change.
   */
  void carryOut(FloorPlan wanted, List<PlanItem> items) {
    FloorPlan before = plan();
    if (wanted.equals(before)) {
      return;
    }
    problem.set(refusal(wanted));
    if (problem.get().isPresent()) {
      return;
    }
    List<PlanItem> selected = selection();
    select(items);
    if (held.isEmpty()) {
      remember(before);
    }
    if (!send(wanted)) {
      select(selected); // the newly selected items may not exist
      if (held.isEmpty()) {
        history.drop();
        showHistory();
      }
    }
  }

  /**
   * Returns the reason why a change to drones or goals must be refused; empty if there is none.
   * Changes to starts, pads and obstacles are always allowed.
   */
  private Optional<PlacementProblem> refusal(FloorPlan wanted) {
    boolean others = !wanted.origins().equals(plan().origins());
    if (!others && wanted.challenge().equals(plan().challenge())) {
      return Optional.empty();
    }
    boolean flying =
        simulation.snapshot().drones().stream().anyMatch(drone -> drone.state().phase().flying());
    return flying ? Optional.of(PlacementProblem.WHILE_FLYING) : Optional.empty();
  }

  /**
   * Sends a change and returns whether it was carried out. A change to the drones opens a new
   * window, unless only their starts change.
   */
  private boolean send(FloorPlan wanted) {
    FloorPlan before = plan();
    if (!wanted.origins().equals(before.origins())) {
      return scenario.actions().replan(wanted.arena(), wanted.drones(), wanted.challenge());
    }
    if (!wanted.arena().equals(before.arena())) {
      actions.carryOut(new Control.Furnish(wanted.arena().obstacles(), wanted.arena().pads()));
    }
    for (int i = 0; i < wanted.starts().size(); i++) {
      Pose start = wanted.starts().get(i);
      if (!start.equals(before.starts().get(i))) {
        actions.carryOut(new Control.SetStart(i + 1, start.position(), start.attitude().heading()));
      }
    }
    show(wanted);
    if (held.isEmpty()) {
      ask(wanted.challenge());
    }
    return true;
  }

  /** Sets the challenge. If any drone has flown, all drones return to their starts. */
  private void ask(Challenge challenge) {
    if (challenge.equals(scenario.challenge())) {
      return;
    }
    boolean flown = scenario.progressProperty().get().elapsed() > 0;
    scenario.ask(challenge);
    if (flown) {
      simulation.drones().forEach(drone -> actions.carryOut(new Control.Reset(drone.number())));
    }
  }

  private void remember(FloorPlan before) {
    history.changed(before);
    showHistory();
  }

  private void forget() {
    history.clear();
    showHistory();
  }

  private void showHistory() {
    undoable.set(history.undoable());
    redoable.set(history.redoable());
  }

  private void show(FloorPlan newest) {
    if (!selection().stream().allMatch(newest::has)) {
      select(selection().stream().filter(newest::has).toList());
    }
    plan.set(newest);
  }
}
