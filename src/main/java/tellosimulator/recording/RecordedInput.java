package tellosimulator.recording;

import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;

/**
 * An input of a simulation. Immutable; for any thread.
 *
 * @param time the end of the step after which it was taken
 */
public record RecordedInput(SimTime time, SimInput input) {}
