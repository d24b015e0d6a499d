package tellosimulator.controller;

import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.command.OperatorSession;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.model.DroneModel;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.SeededNoise;

/**
 * What a controller works with: its drone, what is known of it, and who is told.
 *
 * @param crashSpeed above which a touch is a crash [m/s]
 * @param landsWhenSilent whether it lands by itself when no command comes
 * @param observer is told what happens to the drone
 * @param faults what goes wrong at the moment
 * @param operatorChanged is told when another operator has taken over, before it is answered
 * @param forgetLink called when the power goes
 */
public record ControllerContext(
    DroneModel model,
    Profile profile,
    Behavior behavior,
    double crashSpeed,
    boolean landsWhenSilent,
    OperatorSession session,
    SeededNoise noise,
    ReadReplies reads,
    FlightObserver observer,
    Supplier<ActiveFaults> faults,
    Consumer<OperatorSession.Takeover> operatorChanged,
    Runnable forgetLink) {}
