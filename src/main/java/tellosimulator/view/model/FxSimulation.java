package tellosimulator.view.model;

import java.util.function.BooleanSupplier;
import java.util.function.Function;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The simulation as observable properties. Most of them mirror the latest snapshot; others hold the
 * window's own state, such as the selected drone. Confined to the JavaFX thread.
 */
public final class FxSimulation {

  /**
   * Time between two redraws while nothing moves, unless the window is idle [ns]. Decided: the
   * clock still shows each second.
   */
  private static final long STILL_PERIOD = 1_000_000_000;

  /**
   * Time between two redraws in an idle window [ns]. Measured: with Mesa's llvmpipe, a frame takes
   * 30 ms of processor time, however little of it changes.
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

  /** Creates the model from the first snapshot, and selects the first drone. */
  public FxSimulation(SimSnapshot first) {
    snapshot = first;
    first.drones().forEach(drone -> drones.add(new FxDroneModel(drone)));
    selected.set(drones.get(0));
    update(first);
  }

  /** Updates the properties from the latest snapshot. Must be called at each UI tick. */
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

  /**
   * Sets the condition under which the window is idle. An idle window draws less often, and shows
   * the drones' status lights without blinking.
   */
  void setIdle(BooleanSupplier newIdle) {
    idle = newIdle;
  }

  /**
   * Returns the time between two redraws of values that change with time. It is longer while
   * nothing moves, because each redraw is expensive with software rendering.
   *
   * @param moving the period while something moves [ns]
   */
  public long period(long moving) {
    if (!still()) {
      return moving;
    }
    return idle.getAsBoolean() ? IDLE_PERIOD : STILL_PERIOD;
  }

  /**
   * Returns whether nothing moves: either time is paused, or no drone has running motors, is
   * falling, or has animated lights.
   */
  public boolean still() {
    return paused.get()
        || snapshot.drones().stream()
            .map(DroneSnapshot::state)
            .noneMatch(state -> state.phase().moving() || state.lights().animated());
  }

  /**
   * Returns the snapshot to draw. It equals {@link #snapshot}, except in an idle window, where
   * status lights do not blink.
   */
  public SimSnapshot pictured() {
    return snapshot.withDrones(drones.stream().map(FxDroneModel::pictured).toList());
  }

  /** Returns the latest snapshot, which the properties mirror. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  /** Returns the drones in the order of their numbers. */
  public ObservableList<FxDroneModel> drones() {
    return readOnlyDrones;
  }

  /** The drone that panels and cameras show. */
  public ObjectProperty<FxDroneModel> selectedProperty() {
    return selected;
  }

  /** Returns the drone that panels and cameras show. */
  public FxDroneModel selected() {
    return selected.get();
  }

  /** Returns the value of a property of the selected drone. The value follows the selection. */
  public <T> ObservableValue<T> selected(
      Function<FxDroneModel, ? extends ObservableValue<? extends T>> property) {
    return selected.flatMap(property);
  }

  /**
   * Selects the next or the previous drone; the last drone is followed by the first.
   *
   * @param steps 1 for the next, -1 for the previous drone
   */
  public void selectNext(int steps) {
    int index = Math.floorMod(drones.indexOf(selected()) + steps, drones.size());
    selected.set(drones.get(index));
  }

  /** The room with everything in it. */
  public ReadOnlyObjectProperty<Arena> arenaProperty() {
    return arena.getReadOnlyProperty();
  }

  public ReadOnlyObjectProperty<Room> roomProperty() {
    return room.getReadOnlyProperty();
  }

  /** The appearance of the room. */
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

  /** Simulated time that was skipped because the machine was too slow [simulated s]. */
  public ReadOnlyDoubleProperty lostSecondsProperty() {
    return lostSeconds.getReadOnlyProperty();
  }
}
