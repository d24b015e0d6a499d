package tellosimulator.recording;

import java.util.OptionalDouble;

/**
 * A goal of the scenario that was flown. Immutable; for any thread.
 *
 * @param text what to do, in English words
 * @param reached when, in simulated seconds since the simulation began; empty if it was not
 */
public record RecordedGoal(String text, OptionalDouble reached) {}
