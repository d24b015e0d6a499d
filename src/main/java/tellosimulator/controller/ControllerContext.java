package tellosimulator.controller;

import java.util.function.Supplier;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.model.DroneModel;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.SeededNoise;

/**
 * The parts that a controller works with.
 *
 * @param crashSpeed the speed above which a touch is a crash [m/s]
 * @param landsWhenSilent whether the drone lands automatically when no command arrives
 * @param observer notified of the drone's flight events
 * @param faults the currently active faults
 * @param sessionEnded called when the drone loses power, or when its operator session is ended
 */
public record ControllerContext(
    DroneModel model,
    Profile profile,
    Behavior behavior,
    double crashSpeed,
    boolean landsWhenSilent,
    SeededNoise noise,
    FlightObserver observer,
    Supplier<ActiveFaults> faults,
    Runnable sessionEnded) {}
