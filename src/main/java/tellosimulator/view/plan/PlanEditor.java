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
import tellosimulator.view.FxSimulation;
import tellosimulator.view.SimulatorActions;
import tellosimulator.view.plan.Piece.Pad;
import tellosimulator.view.plan.Piece.Start;
import tellosimulator.view.plan.Piece.Thing;
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
  private final ReadOnlyObjectWrapper<Layout> layout;
  private final ObjectProperty<Optional<Piece>> selected =
      new SimpleObjectProperty<>(this, "selected", Optional.empty());
  private final ReadOnlyObjectWrapper<Optional<Fit>> problem =
      new ReadOnlyObjectWrapper<>(this, "problem", Optional.empty());
  private final ReadOnlyBooleanWrapper undoable = new ReadOnlyBooleanWrapper(this, "undoable");
  private final ReadOnlyBooleanWrapper redoable = new ReadOnlyBooleanWrapper(this, "redoable");
  private final History history = new History();

  /** How it was when the hand took hold of something. */
  private Optional<Layout> held = Optional.empty();

  /**
   * @param goals of the scenario, which name what must stay
   */
  PlanEditor(FxSimulation simulation, SimulatorActions actions, List<Goal> goals) {
    this.simulation = simulation;
    this.goals = List.copyOf(goals);
    this.actions = actions;
    this.layout = new ReadOnlyObjectWrapper<>(Layout.of(simulation.snapshot()));
  }

  /** Takes over what the newest snapshot says; once a pulse while somebody looks. */
  void advance() {
    Layout newest = Layout.of(simulation.snapshot());
    Layout before = layout.get();
    if (newest.equals(before)) {
      return;
    }
    if (!newest.arena().room().equals(before.arena().room())) {
      forget(); // what was in the other room may be outside of this one
    }
    show(newest);
  }

  /** What is where. */
  ReadOnlyObjectProperty<Layout> layoutProperty() {
    return layout.getReadOnlyProperty();
  }

  Layout layout() {
    return layout.get();
  }

  /** The piece that keys and wheel move; empty if there is none. */
  ObjectProperty<Optional<Piece>> selectedProperty() {
    return selected;
  }

  Optional<Piece> selected() {
    return selected.get();
  }

  /** Why the last thing that was wanted was not done; empty if it was. */
  ReadOnlyObjectProperty<Optional<Fit>> problemProperty() {
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
    held = Optional.of(layout());
  }

  /** Ends a change that began with {@link #hold}. */
  void release() {
    Optional<Layout> was = held;
    held = Optional.empty();
    was.filter(before -> !before.equals(layout())).ifPresent(this::remember);
    problem.set(Optional.empty());
  }

  /** Puts the selected piece elsewhere, if it fits there. */
  void place(Spot spot) {
    selected()
        .ifPresent(
            piece -> {
              Layout wanted = layout().with(piece, spot);
              tryOut(wanted, piece);
            });
  }

  /** Makes another obstacle of the selected one, if that fits. */
  void replace(Obstacle obstacle) {
    if (selected().orElse(null) instanceof Thing thing) {
      tryOut(layout().with(thing, obstacle), thing);
    }
  }

  /** Adds an obstacle near a place, and selects it. */
  void add(Stock kind, Vec3 near) {
    Room room = layout().arena().room();
    String name = layout().freeName(kind.word());
    int index = layout().arena().obstacles().size();
    addNear(
        near,
        new Thing(index),
        place -> layout().with(new Obstacle(name, kind.shape(room), place, 0, kind.cover())));
  }

  /** Adds the mission pad of the next free id near a place, if there is one left. */
  void addPad(Vec3 near) {
    layout()
        .freePadId()
        .ifPresent(
            id ->
                addNear(
                    near, new Pad(id), place -> layout().with(MissionPad.onFloor(id, place, 0))));
  }

  private interface Adding {
    Layout at(Vec3 place);
  }

  /** Beside what is there if there is room for it, otherwise where it fits. */
  private void addNear(Vec3 near, Piece piece, Adding adding) {
    boolean added =
        tryAround(near, piece, adding, PlanEditor::apart)
            || tryAround(near, piece, adding, (wanted, other) -> true);
    if (!added) {
      problem.set(Fit.problem(adding.at(near), piece).or(() -> Optional.of(Fit.OUTSIDE)));
    }
  }

  /** Tries places around one, from the nearest ring to the farthest. */
  private boolean tryAround(
      Vec3 near, Piece piece, Adding adding, BiPredicate<Layout, Piece> wish) {
    for (int ring = 0; ring <= MOST_RINGS; ring++) {
      for (int x = -ring; x <= ring; x++) {
        for (int y = -ring; y <= ring; y++) {
          Vec3 place = near.plus(new Vec3(x * RASTER, y * RASTER, 0)).withZ(0);
          if (Math.max(Math.abs(x), Math.abs(y)) == ring) {
            Layout wanted = adding.at(place);
            if (Fit.problem(wanted, piece).isEmpty() && wish.test(wanted, piece)) {
              carryOut(wanted);
              selected.set(Optional.of(piece));
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  /** Whether a new piece is clear of all others, however they are turned. */
  private static boolean apart(Layout wanted, Piece piece) {
    Vec3 place = wanted.spot(piece).place();
    double reach = wanted.outline(piece).reach();
    return wanted.pieces().stream()
        .filter(other -> !other.equals(piece))
        .noneMatch(other -> wanted.outline(other).covers(place, wanted.spot(other), reach));
  }

  /** Takes the selected piece away, unless it is a drone's start or a goal names it. */
  void remove() {
    selected().filter(piece -> !(piece instanceof Start)).ifPresent(this::remove);
  }

  private void remove(Piece piece) {
    problem.set(Fit.problemWithout(layout(), piece, goals));
    if (problem.get().isEmpty()) {
      selected.set(Optional.empty());
      carryOut(layout().without(piece));
    }
  }

  /** Makes the last change undone. */
  void undo() {
    history.undone(layout()).ifPresent(this::restore);
  }

  /** Does again what was undone last. */
  void redo() {
    history.redone(layout()).ifPresent(this::restore);
  }

  private void restore(Layout wanted) {
    held = Optional.empty();
    problem.set(Optional.empty());
    send(wanted.in(layout().arena()));
    showHistory();
  }

  private void tryOut(Layout wanted, Piece piece) {
    problem.set(Fit.problem(wanted, piece));
    if (problem.get().isEmpty()) {
      carryOut(wanted);
    }
  }

  private void carryOut(Layout wanted) {
    Layout before = layout();
    if (wanted.equals(before)) {
      return;
    }
    problem.set(Optional.empty());
    send(wanted);
    if (held.isEmpty()) {
      remember(before);
    }
  }

  private void send(Layout wanted) {
    Layout before = layout();
    if (!wanted.arena().equals(before.arena())) {
      actions.carryOut(new Control.Furnish(wanted.arena()));
    }
    for (int i = 0; i < wanted.starts().size(); i++) {
      Pose start = wanted.starts().get(i);
      if (!start.equals(before.starts().get(i))) {
        actions.carryOut(new Control.SetStart(i + 1, start.position(), start.attitude().heading()));
      }
    }
    show(wanted);
  }

  private void remember(Layout before) {
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

  private void show(Layout newest) {
    if (selected().filter(piece -> !newest.has(piece)).isPresent()) {
      selected.set(Optional.empty());
    }
    layout.set(newest);
  }
}
