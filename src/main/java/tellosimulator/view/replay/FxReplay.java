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
 * Provides views with the displayed moment of a recorded flight and of its ghost, as properties.
 * Confined to the JavaFX thread, except {@link #snapshot}.
 */
final class FxReplay {

  /**
   * Colour of ghosts, as 0xRRGGBB. Decided: a purple that no drone has by default, and on which
   * white letters are readable.
   */
  static final int GHOST_RGB = 0x8f3fb0;

  /**
   * Minimum time between two points of a redrawn trail [s]. Decided: the interval of the recorded
   * samples.
   */
  private static final double TRAIL_STEP = 0.05;

  /**
   * Maximum number of drone states used to redraw trails. Decided: redrawing then takes only a few
   * milliseconds.
   */
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

  /** Returns the properties of the displayed moment. */
  FxSimulation simulation() {
    return simulation;
  }

  /** The ghost: the flight with which the recorded flight is compared, if there is one. */
  ObjectProperty<Optional<ReplayFlight>> ghostProperty() {
    return ghost;
  }

  /** A sentence about an operation that is in progress or has failed; may be empty. */
  StringProperty newsProperty() {
    return news;
  }

  /** Returns the snapshot of the displayed moment. Thread-safe. */
  SimSnapshot snapshot() {
    return snapshot;
  }

  /**
   * Advances the playback.
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

  /**
   * Returns the ghost's snapshot at the same time after takeoff as the displayed moment; empty if
   * there is no ghost.
   */
  Optional<SimSnapshot> ghostSnapshot() {
    return ghostSnapshot;
  }

  private double ghostTime(ReplayFlight other) {
    return flight.timeIn(other, playback.time());
  }

  /**
   * Returns the distance between the selected drone and its ghost [m]; empty if it has no ghost.
   */
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

  /** Returns the snapshots up to the displayed moment, for redrawing trails. */
  List<SimSnapshot> past() {
    return past(flight.snapshots(), flight.begin(), playback.time());
  }

  /** Returns the snapshots of the ghost up to the displayed moment. */
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
