package tellosimulator.view.model;

import java.util.function.BooleanSupplier;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The simulation as properties that views bind to: a mirror of the newest snapshot, and what the
 * window alone decides about it (which drone is looked at). For the JavaFX thread only.
 */
public final class FxSimulation {

  /** Time between two drawings while nothing moves [ns]. Decided: a clock's second. */
  private static final long STILL_PERIOD = 1_000_000_000;

  /**
   * The same in an idle window [ns]. Measured: a frame takes 30 ms of a processor where Mesa's
   * llvmpipe draws, however little of it changes.
   */
  private static final long IDLE_PERIOD = 2_000_000_000;

  private final ObservableList<FxDroneModel> drones = FXCollections.observableArrayList();
  private final ObservableList<FxDroneModel> readOnlyDrones =
      FXCollections.unmodifiableObservableList(drones);
  private final ObjectProperty<FxDroneModel> selected = new SimpleObjectProperty<>();
  private final ReadOnlyObjectWrapper<Arena> arena = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<Room> room = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<Decor> decor = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<TimeFactor> timeFactor = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyBooleanWrapper paused = new ReadOnlyBooleanWrapper();
  private final ReadOnlyDoubleWrapper seconds = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper lostSeconds = new ReadOnlyDoubleWrapper();
  private BooleanSupplier idle = () -> false;
  private SimSnapshot snapshot;

  /** Shows a first snapshot, and looks at its first drone. */
  public FxSimulation(SimSnapshot first) {
    snapshot = first;
    first.drones().forEach(drone -> drones.add(new FxDroneModel(drone)));
    selected.set(drones.get(0));
    update(first);
  }

  /** Takes over what the newest snapshot says; called once a pulse. */
  public void update(SimSnapshot newest) {
    snapshot = newest;
    arena.set(newest.arena());
    room.set(newest.room());
    decor.set(newest.decor());
    timeFactor.set(newest.clock().factor());
    paused.set(newest.clock().paused());
    seconds.set(newest.time().seconds());
    lostSeconds.set(newest.clock().lostSeconds());
    for (int i = 0; i < drones.size(); i++) {
      drones.get(i).update(newest.drones().get(i), idle.getAsBoolean());
    }
  }

  /** Draws less often while the window is idle, and shows drones whose lamps do not blink. */
  void setIdle(BooleanSupplier newIdle) {
    idle = newIdle;
  }

  /**
   * Time between two drawings of what tells of time. Longer while nothing moves: where the
   * processor draws, each costs much.
   *
   * @param moving while something moves [ns]
   */
  public long period(long moving) {
    if (!still()) {
      return moving;
    }
    return idle.getAsBoolean() ? IDLE_PERIOD : STILL_PERIOD;
  }

  /**
   * Whether nothing moves, because time stands still or no drone has its motors on, falls, or has
   * lights that change.
   */
  public boolean still() {
    return paused.get()
        || snapshot.drones().stream()
            .map(DroneSnapshot::state)
            .noneMatch(state -> state.phase().moving() || state.lights().animated());
  }

  /** What pictures show: the snapshot, but for the lamps of an idle window, which do not blink. */
  public SimSnapshot pictured() {
    return snapshot.withDrones(drones.stream().map(FxDroneModel::pictured).toList());
  }

  /** The snapshot of which this is the mirror. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  /** In the order of their numbers. */
  public ObservableList<FxDroneModel> drones() {
    return readOnlyDrones;
  }

  /** The drone that panels and cameras show. */
  public ObjectProperty<FxDroneModel> selectedProperty() {
    return selected;
  }

  /** The drone that panels and cameras show. */
  public FxDroneModel selected() {
    return selected.get();
  }

  /**
   * Looks at another drone; the last one is followed by the first.
   *
   * @param steps 1 for the next, -1 for the one before
   */
  public void selectNext(int steps) {
    int index = Math.floorMod(drones.indexOf(selected()) + steps, drones.size());
    selected.set(drones.get(index));
  }

  /** The room with all that is in it. */
  public ReadOnlyObjectProperty<Arena> arenaProperty() {
    return arena.getReadOnlyProperty();
  }

  public ReadOnlyObjectProperty<Room> roomProperty() {
    return room.getReadOnlyProperty();
  }

  /** What the room looks like. */
  public ReadOnlyObjectProperty<Decor> decorProperty() {
    return decor.getReadOnlyProperty();
  }

  public ReadOnlyObjectProperty<TimeFactor> timeFactorProperty() {
    return timeFactor.getReadOnlyProperty();
  }

  public ReadOnlyBooleanProperty pausedProperty() {
    return paused.getReadOnlyProperty();
  }

  /** Simulated time since the start [s]. */
  public ReadOnlyDoubleProperty secondsProperty() {
    return seconds.getReadOnlyProperty();
  }

  /** What of simulated time was left out, because the machine was too slow [simulated s]. */
  public ReadOnlyDoubleProperty lostSecondsProperty() {
    return lostSeconds.getReadOnlyProperty();
  }
}
