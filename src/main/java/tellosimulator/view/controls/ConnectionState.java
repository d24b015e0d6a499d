package tellosimulator.view.controls;

import java.util.Locale;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/** The stages of connecting a program to a drone. */
enum ConnectionState {
  OFF,
  WAITING,
  CONNECTED;

  static ConnectionState of(DroneSnapshot drone) {
    if (drone.state().phase() == FlightPhase.OFF) {
      return OFF;
    }
    return drone.link().operator().isPresent() ? CONNECTED : WAITING;
  }

  /** Returns the name used in message keys and style sheets. */
  String key() {
    return name().toLowerCase(Locale.ROOT);
  }
}
