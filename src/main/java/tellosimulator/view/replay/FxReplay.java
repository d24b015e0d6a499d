package tellosimulator.view.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import tellosimulator.math.Vec3;
import tellosimulator.recording.FlightSnapshots;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.model.FxSimulation;

/**
 * A recorded flight and its ghost at the moment that is shown, as what views bind to. For the
 * JavaFX thread, but for {@link #snapshot}.
 */
final class FxReplay {

  /**
   * Colour of ghosts, as one writes #rrggbb. Decided: a purple that no drone has by its number, and
   * on which white letters can be read.
   */
  static final int GHOST_RGB = 0x8f3fb0;

  /** Time between two points of a trail that is drawn anew [s]. Decided: that of the samples. */
  private static final double TRAIL_STEP = 0.05;

  /** Most states of drones of which trails are drawn anew. Decided: some milliseconds. */
  private static final int MOST_TRAIL_STATES = 20_000;

  private final ReplayFlight flight;
  private final Playback playback;
  private final FxSimulation simulation;
  private final ObjectProperty<Optional<ReplayFlight>> ghost =
      new SimpleObjectProperty<>(this, "ghost", Optional.empty());
  private final StringProperty news = new SimpleStringProperty(this, "news", "");
  private volatile SimSnapshot snapshot;
  private Optional<SimSnapshot> ghostSnapshot = Optional.empty();

  FxReplay(ReplayFlight flight) {
    this.flight = flight;
    playback = new Playback(flight.begin(), flight.end());
    snapshot = flight.snapshots().at(playback.time());
    simulation = new FxSimulation(snapshot);
    ghost.subscribe(this::moveGhost);
  }

  ReplayFlight flight() {
    return flight;
  }

  Playback playback() {
    return playback;
  }

  /** The mirror of the moment. */
  FxSimulation simulation() {
    return simulation;
  }

  /** The flight that is compared with, in the colour of ghosts. */
  ObjectProperty<Optional<ReplayFlight>> ghostProperty() {
    return ghost;
  }

  /** What is being done, or what did not work, in a sentence; may be empty. */
  StringProperty newsProperty() {
    return news;
  }

  /** What is to be seen at the moment; for any thread. */
  SimSnapshot snapshot() {
    return snapshot;
  }

  /**
   * Moves on.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    playback.advance(nanos);
    double time = playback.time();
    if (snapshot.time().seconds() != Math.max(0, time)) {
      snapshot = flight.snapshots().at(time);
      moveGhost();
    }
    simulation.update(snapshot);
  }

  private void moveGhost() {
    ghostSnapshot = ghost.get().map(other -> other.snapshots().at(ghostTime(other)));
  }

  /** What is to be seen of the ghost, at the same moment after the takeoff. */
  Optional<SimSnapshot> ghostSnapshot() {
    return ghostSnapshot;
  }

  private double ghostTime(ReplayFlight other) {
    return flight.timeIn(other, playback.time());
  }

  /** How far the selected drone is from its ghost [m]; empty if it has none. */
  OptionalDouble distance() {
    int number = simulation.selected().number();
    Optional<Vec3> own = place(snapshot, number);
    Optional<Vec3> other = ghostSnapshot.flatMap(now -> place(now, number));
    return own.isPresent() && other.isPresent()
        ? OptionalDouble.of(own.get().distanceTo(other.get()))
        : OptionalDouble.empty();
  }

  private static Optional<Vec3> place(SimSnapshot moment, int drone) {
    return moment.drones().stream()
        .map(DroneSnapshot::state)
        .filter(state -> state.drone() == drone)
        .map(state -> state.motion().position())
        .findFirst();
  }

  /** What was to be seen until now, for trails. */
  List<SimSnapshot> past() {
    return past(flight.snapshots(), flight.begin(), playback.time());
  }

  /** The same of the ghost. */
  List<SimSnapshot> ghostPast() {
    return ghost
        .get()
        .map(other -> past(other.snapshots(), other.begin(), ghostTime(other)))
        .orElse(List.of());
  }

  private List<SimSnapshot> past(FlightSnapshots snapshots, double begin, double now) {
    int drones = simulation.drones().size();
    double step = Math.max(TRAIL_STEP, (now - begin) * drones / MOST_TRAIL_STATES);
    List<SimSnapshot> past = new ArrayList<>();
    for (int i = 0; begin + i * step < now; i++) {
      past.add(snapshots.at(begin + i * step));
    }
    return past;
  }
}
