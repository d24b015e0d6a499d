package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.Start;

/**
 * What is placed in the room, what of it is chosen, and what can be undone. Each change is sent to
 * the simulation at once; what would not fit is not sent. For the JavaFX thread.
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

  /** How it was when the hand took hold of something. */
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

  /** Takes over what the newest snapshot says; once a pulse while somebody looks. */
  void advance() {
    if (actions.pending()) {
      return; // the snapshot does not show it yet
    }
    FloorPlan before = plan.get();
    FloorPlan newest = present(held.isPresent() ? before.challenge() : scenario.challenge());
    if (newest.equals(before)) {
      return;
    }
    if (!newest.arena().room().equals(before.arena().room())) {
      forget(); // what was in the other room may be outside of this one
    }
    show(newest);
  }

  /** What was done until now, for the editor of another window. */
  UndoStack history() {
    return history;
  }

  /** Goes on with what was done in another window. */
  void goOn(UndoStack done, List<PlanItem> selected) {
    history = done;
    select(selected.stream().filter(plan()::has).toList());
    showHistory();
  }

  /** What is where. */
  ReadOnlyObjectProperty<FloorPlan> planProperty() {
    return plan.getReadOnlyProperty();
  }

  FloorPlan plan() {
    return plan.get();
  }

  /** The items that mouse, keys and wheel change; the last one was selected last. */
  ReadOnlyObjectProperty<List<PlanItem>> selectionProperty() {
    return selection.getReadOnlyProperty();
  }

  List<PlanItem> selection() {
    return selection.get();
  }

  /** The item that was selected last; empty if there is none. */
  Optional<PlanItem> selected() {
    List<PlanItem> all = selection();
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(all.size() - 1));
  }

  /** Selects nothing but these. */
  void select(List<PlanItem> items) {
    selection.set(List.copyOf(items));
  }

  /** Selects an item beside the others, or no longer. */
  void toggle(PlanItem item) {
    List<PlanItem> items = new ArrayList<>(selection());
    if (!items.remove(item)) {
      items.add(item);
    }
    select(items);
  }

  /** Why the last item that was wanted was not done; empty if it was. */
  ReadOnlyObjectProperty<Optional<PlacementProblem>> problemProperty() {
    return problem.getReadOnlyProperty();
  }

  ReadOnlyBooleanProperty undoableProperty() {
    return undoable.getReadOnlyProperty();
  }

  ReadOnlyBooleanProperty redoableProperty() {
    return redoable.getReadOnlyProperty();
  }

  /** Begins a change that takes several moves and is undone as one. */
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

  /** Puts the item that was selected last elsewhere, and the others beside it, if all fit. */
  void place(Placement placement) {
    selected()
        .ifPresent(
            item -> {
              Vec3 way = placement.place().minus(plan().placement(item).place());
              FloorPlan wanted = placed(item, placement);
              for (PlanItem other : selection().subList(0, selection().size() - 1)) {
                Placement beside = plan().placement(other);
                wanted = wanted.with(other, beside.at(beside.place().plus(way)));
              }
              tryOut(wanted);
            });
  }

  /** A goal that is moved alone goes to another gate or pad, if it names one. */
  private FloorPlan placed(PlanItem item, Placement placement) {
    boolean named = item instanceof GoalItem goal && !(plan().goal(goal) instanceof Goal.InRegion);
    if (!named || selection().size() > 1) {
      return plan().with(item, placement);
    }
    GoalItem goal = (GoalItem) item;
    return plan().with(goal, GoalPlacement.renamed(plan().goal(goal), placement.place(), plan()));
  }

  /** Moves the selected items to an edge or a line of the one that was selected last. */
  void align(Alignment alignment) {
    tryOut(alignment.aligned(plan(), selection()));
  }

  /** Whether something is selected that can be taken away: one drone stays. */
  boolean removable() {
    long starts = selection().stream().filter(Start.class::isInstance).count();
    return !selection().isEmpty()
        && (selection().size() > starts || starts < plan().drones().size());
  }

  /** Takes the selected items away, unless a goal or a fault names one. */
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

  /** Whether another number of a drone would be another drone to a fault. */
  boolean faultNamesDrone() {
    return scenario.scenario().config().rules().faults().faults().stream()
        .anyMatch(fault -> fault.target().drone().isPresent());
  }

  /** Makes the last change undone. */
  void undo() {
    history
        .undone(plan())
        .filter(wanted -> !restored(wanted))
        .ifPresent(wanted -> history.redone(wanted)); // as before
  }

  /** Does again what was undone last. */
  void redo() {
    history
        .redone(plan())
        .filter(wanted -> !restored(wanted))
        .ifPresent(wanted -> history.undone(wanted)); // as before
  }

  private boolean restored(FloorPlan earlier) {
    held = Optional.empty();
    FloorPlan wanted = earlier.in(plan().arena());
    problem.set(refusal(wanted));
    boolean done = problem.get().isEmpty() && send(wanted);
    showHistory();
    return done;
  }

  /** Carries a change of the selected items out, if all of them fit. */
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

  /** Says why something was not done. */
  void refuse(PlacementProblem why) {
    problem.set(Optional.of(why));
  }

  /** Selects items, and carries a change of them out: another window may go on from there. */
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
      select(selected); // those selected now may not be there
      if (held.isEmpty()) {
        history.drop();
        showHistory();
      }
    }
  }

  /** What keeps drones and goals from being other ones; empty if nothing does. */
  private Optional<PlacementProblem> refusal(FloorPlan wanted) {
    boolean others = !wanted.origins().equals(plan().origins());
    if (!others && wanted.challenge().equals(plan().challenge())) {
      return Optional.empty();
    }
    boolean flying =
        simulation.snapshot().drones().stream().anyMatch(drone -> drone.state().phase().flying());
    return flying ? Optional.of(PlacementProblem.WHILE_FLYING) : Optional.empty();
  }

  /** Carries it out; whether it was done. Other drones need a window that is opened anew. */
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

  /** Asks it of the drones, which go back to their starts if they have flown. */
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
