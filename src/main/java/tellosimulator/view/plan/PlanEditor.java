package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/**
 * What is placed in the room, what of it is chosen, and what can be undone. Each change is sent to
 * the simulation at once; what would not fit is not sent. For the JavaFX thread.
 */
final class PlanEditor {

  /** Distance between places at which something new is tried [m]. Decided. */
  private static final double RASTER = 0.25;

  /** How far from a place something new is tried, in rasters. Decided: seven metres. */
  private static final int MOST_RINGS = 28;

  private final SimulatorActions actions;
  private final FxSimulation simulation;
  private final List<Goal> goals;
  private final ReadOnlyObjectWrapper<FloorPlan> plan;
  private final ObjectProperty<Optional<PlanItem>> selected =
      new SimpleObjectProperty<>(this, "selected", Optional.empty());
  private final ReadOnlyObjectWrapper<Optional<PlacementProblem>> problem =
      new ReadOnlyObjectWrapper<>(this, "problem", Optional.empty());
  private final ReadOnlyBooleanWrapper undoable = new ReadOnlyBooleanWrapper(this, "undoable");
  private final ReadOnlyBooleanWrapper redoable = new ReadOnlyBooleanWrapper(this, "redoable");
  private final UndoStack history = new UndoStack();

  /** How it was when the hand took hold of something. */
  private Optional<FloorPlan> held = Optional.empty();

  /**
   * @param goals of the scenario, which name what must stay
   */
  PlanEditor(FxSimulation simulation, SimulatorActions actions, List<Goal> goals) {
    this.simulation = simulation;
    this.goals = List.copyOf(goals);
    this.actions = actions;
    this.plan = new ReadOnlyObjectWrapper<>(FloorPlan.of(simulation.snapshot()));
  }

  /** Takes over what the newest snapshot says; once a pulse while somebody looks. */
  void advance() {
    if (actions.pending()) {
      return; // the snapshot does not show it yet
    }
    FloorPlan newest = FloorPlan.of(simulation.snapshot());
    FloorPlan before = plan.get();
    if (newest.equals(before)) {
      return;
    }
    if (!newest.arena().room().equals(before.arena().room())) {
      forget(); // what was in the other room may be outside of this one
    }
    show(newest);
  }

  /** What is where. */
  ReadOnlyObjectProperty<FloorPlan> planProperty() {
    return plan.getReadOnlyProperty();
  }

  FloorPlan plan() {
    return plan.get();
  }

  /** The item that keys and wheel move; empty if there is none. */
  ObjectProperty<Optional<PlanItem>> selectedProperty() {
    return selected;
  }

  Optional<PlanItem> selected() {
    return selected.get();
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
    was.filter(before -> !before.equals(plan())).ifPresent(this::remember);
    problem.set(Optional.empty());
  }

  /** Puts the selected item elsewhere, if it fits there. */
  void place(Placement placement) {
    selected()
        .ifPresent(
            item -> {
              FloorPlan wanted = plan().with(item, placement);
              tryOut(wanted, item);
            });
  }

  /** Makes another obstacle of the selected one, if that fits. */
  void replace(Obstacle obstacle) {
    if (selected().orElse(null) instanceof ObstacleItem body) {
      tryOut(plan().with(body, obstacle), body);
    }
  }

  /** Adds an obstacle near a place, and selects it. */
  void add(PaletteItem kind, Vec3 near) {
    Room room = plan().arena().room();
    String name = plan().freeName(kind.word());
    int index = plan().arena().obstacles().size();
    addNear(
        near,
        new ObstacleItem(index),
        place -> plan().with(new Obstacle(name, kind.shape(room), place, 0, kind.cover())));
  }

  /** Adds the mission pad of the next free id near a place, if there is one left. */
  void addPad(Vec3 near) {
    plan()
        .freePadId()
        .ifPresent(
            id ->
                addNear(near, new Pad(id), place -> plan().with(MissionPad.onFloor(id, place, 0))));
  }

  private interface Adding {
    FloorPlan at(Vec3 place);
  }

  /** Beside what is there if there is room for it, otherwise where it fits. */
  private void addNear(Vec3 near, PlanItem item, Adding adding) {
    boolean added =
        tryAround(near, item, adding, PlanEditor::apart)
            || tryAround(near, item, adding, (wanted, other) -> true);
    if (!added) {
      problem.set(
          PlacementProblem.problem(adding.at(near), item)
              .or(() -> Optional.of(PlacementProblem.OUTSIDE)));
    }
  }

  /** Tries places around one, from the nearest ring to the farthest. */
  private boolean tryAround(
      Vec3 near, PlanItem item, Adding adding, BiPredicate<FloorPlan, PlanItem> wish) {
    for (int ring = 0; ring <= MOST_RINGS; ring++) {
      for (int x = -ring; x <= ring; x++) {
        for (int y = -ring; y <= ring; y++) {
          Vec3 place = near.plus(new Vec3(x * RASTER, y * RASTER, 0)).withZ(0);
          if (Math.max(Math.abs(x), Math.abs(y)) == ring) {
            FloorPlan wanted = adding.at(place);
            if (PlacementProblem.problem(wanted, item).isEmpty() && wish.test(wanted, item)) {
              carryOut(wanted);
              selected.set(Optional.of(item));
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  /** Whether a new item is clear of all others, however they are turned. */
  private static boolean apart(FloorPlan wanted, PlanItem item) {
    Vec3 place = wanted.placement(item).place();
    double reach = wanted.outline(item).reach();
    return wanted.items().stream()
        .filter(other -> !other.equals(item))
        .noneMatch(other -> wanted.outline(other).covers(place, wanted.placement(other), reach));
  }

  /** Takes the selected item away, unless it is a drone's start or a goal names it. */
  void remove() {
    selected().filter(item -> !(item instanceof Start)).ifPresent(this::remove);
  }

  private void remove(PlanItem item) {
    problem.set(PlacementProblem.problemWithout(plan(), item, goals));
    if (problem.get().isEmpty()) {
      selected.set(Optional.empty());
      carryOut(plan().without(item));
    }
  }

  /** Makes the last change undone. */
  void undo() {
    history.undone(plan()).ifPresent(this::restore);
  }

  /** Does again what was undone last. */
  void redo() {
    history.redone(plan()).ifPresent(this::restore);
  }

  private void restore(FloorPlan wanted) {
    held = Optional.empty();
    problem.set(Optional.empty());
    send(wanted.in(plan().arena()));
    showHistory();
  }

  private void tryOut(FloorPlan wanted, PlanItem item) {
    problem.set(PlacementProblem.problem(wanted, item));
    if (problem.get().isEmpty()) {
      carryOut(wanted);
    }
  }

  private void carryOut(FloorPlan wanted) {
    FloorPlan before = plan();
    if (wanted.equals(before)) {
      return;
    }
    problem.set(Optional.empty());
    send(wanted);
    if (held.isEmpty()) {
      remember(before);
    }
  }

  private void send(FloorPlan wanted) {
    FloorPlan before = plan();
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
    if (selected().filter(item -> !newest.has(item)).isPresent()) {
      selected.set(Optional.empty());
    }
    plan.set(newest);
  }
}
