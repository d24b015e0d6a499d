package tellosimulator.command;

import java.util.function.Supplier;
import tellosimulator.controller.DroneController;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.model.DroneState;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.Instruments;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.time.SimTime;

/**
 * The parts of a drone that a protocol works with.
 *
 * @param state supplies the drone's state at the end of the last step
 * @param faults supplies the currently active faults
 * @param session the session with the operator, shared by all protocols of the drone
 * @param port sends to the operator and to other peers
 * @param camera takes the drone's photos
 * @param observer notified of traffic and of the drone's flight events
 */
public record ProtocolContext(
    DroneController controller,
    Profile profile,
    Behavior behavior,
    Instruments instruments,
    SeededNoise noise,
    Supplier<DroneState> state,
    Supplier<ActiveFaults> faults,
    OperatorSession session,
    DronePort port,
    PhotoCamera camera,
    CommandObserver observer) {

  SimTime now() {
    return controller.now();
  }
}
