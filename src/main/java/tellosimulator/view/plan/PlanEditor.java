package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
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
import tellosimulator.world.ObstacleAppearance;
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
  private final ReadOnlyObjectWrapper<List<PlanItem>> selection =
      new ReadOnlyObjectWrapper<>(this, "selection", List.of());
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
    was.filter(before -> !before.equals(plan())).ifPresent(this::remember);
    problem.set(Optional.empty());
  }

  /** Puts the item that was selected last elsewhere, and the others beside it, if all fit. */
  void place(Placement placement) {
    selected()
        .ifPresent(
            item -> {
              Vec3 way = placement.place().minus(plan().placement(item).place());
              FloorPlan wanted = plan().with(item, placement);
              for (PlanItem other : selection().subList(0, selection().size() - 1)) {
                Placement beside = plan().placement(other);
                wanted = wanted.with(other, beside.at(beside.place().plus(way)));
              }
              tryOut(wanted);
            });
  }

  /** Moves the selected items to an edge or a line of the one that was selected last. */
  void align(Alignment alignment) {
    tryOut(alignment.aligned(plan(), selection()));
  }

  /** Gives the item that was selected last another number. */
  void change(ItemProperty property, double value) {
    selected()
        .filter(item -> property.of(plan(), item).isPresent())
        .ifPresent(item -> tryOut(property.with(plan(), item, value)));
  }

  /** Gives the selected obstacle another name, if no other has it. */
  void rename(String name) {
    if (selected().orElse(null) instanceof ObstacleItem body) {
      FloorPlan wanted = plan().with(body, plan().obstacle(body).named(name));
      boolean taken =
          plan().arena().obstacles().stream()
              .anyMatch(other -> other.name().equals(name) && !other.equals(plan().obstacle(body)));
      problem.set(
          taken
              ? Optional.of(PlacementProblem.NAME_TAKEN)
              : PlacementProblem.problemWithGoals(plan(), wanted, goals));
      if (problem.get().isEmpty()) {
        carryOut(wanted);
      }
    }
  }

  /** Gives the selected obstacle another colour, as one writes #rrggbb. */
  void paint(int rgb) {
    if (selected().orElse(null) instanceof ObstacleItem body) {
      Obstacle now = plan().obstacle(body);
      ObstacleAppearance cover =
          new ObstacleAppearance(rgb, now.cover().pattern(), now.cover().pictures());
      carryOut(
          plan()
              .with(body, new Obstacle(now.name(), now.shape(), now.foot(), now.heading(), cover)));
    }
  }

  /** Gives the selected mission pad another number, if no goal names it. */
  void renumber(int id) {
    if (selected().orElse(null) instanceof Pad known && known.id() != id) {
      MissionPad now = plan().pad(known);
      MissionPad renumbered =
          new MissionPad(id, now.surface(), now.along(), now.height(), now.rotation());
      FloorPlan wanted = plan().replacing(known.id(), renumbered);
      problem.set(PlacementProblem.problemWithGoals(plan(), wanted, goals));
      if (problem.get().isEmpty()) {
        select(List.of(new Pad(id)));
        carryOut(wanted);
      }
    }
  }

  /** Adds another obstacle or mission pad like the one that was selected last, beside it. */
  void duplicate() {
    PlanItem item = selected().orElse(null);
    if (item instanceof ObstacleItem body) {
      Obstacle like = plan().obstacle(body);
      String name = plan().freeName(like.name().replaceFirst(" [0-9]+$", ""));
      addNear(
          like.foot(),
          new ObstacleItem(plan().arena().obstacles().size()),
          place ->
              plan().with(like.named(name).movedTo(place.withZ(like.foot().z()), like.heading())));
    } else if (item instanceof Pad pad) {
      addPad(plan().placement(pad).place());
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
    plan().freePadIds().stream()
        .findFirst()
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
              select(List.of(item));
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

  /** Whether something is selected that can be taken away: drones' starts stay. */
  boolean removable() {
    return selection().stream().anyMatch(item -> !(item instanceof Start));
  }

  /** Takes the selected items away, unless they are drones' starts or a goal names one. */
  void remove() {
    FloorPlan wanted = plan();
    List<PlanItem> last = // so that the indices of those before stay
        selection().stream()
            .sorted(
                Comparator.comparingInt(
                    item -> item instanceof ObstacleItem body ? -body.index() : 0))
            .toList();
    for (PlanItem item : last) {
      wanted = wanted.without(item);
    }
    problem.set(PlacementProblem.problemWithGoals(plan(), wanted, goals));
    if (problem.get().isEmpty() && removable()) {
      select(List.of());
      carryOut(wanted);
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

  /** Carries a change of the selected items out, if all of them fit. */
  private void tryOut(FloorPlan wanted) {
    problem.set(
        selection().stream()
            .flatMap(item -> PlacementProblem.problem(wanted, item).stream())
            .findFirst());
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
    if (!selection().stream().allMatch(newest::has)) {
      select(selection().stream().filter(newest::has).toList());
    }
    plan.set(newest);
  }
}
