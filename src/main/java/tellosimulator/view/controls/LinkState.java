package tellosimulator.view.controls;

import java.util.Locale;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/** How far a drone is from being flown by a program. */
enum LinkState {
  OFF,
  WAITING,
  CONNECTED;

  static LinkState of(DroneSnapshot drone) {
    if (drone.state().phase() == FlightPhase.OFF) {
      return OFF;
    }
    return drone.link().operator().isPresent() ? CONNECTED : WAITING;
  }

  /** Its name in keys of texts and in style sheets. */
  String key() {
    return name().toLowerCase(Locale.ROOT);
  }
}
