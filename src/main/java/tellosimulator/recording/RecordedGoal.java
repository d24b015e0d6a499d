package tellosimulator.recording;

import java.util.OptionalDouble;

/**
 * A goal of the scenario that was flown. Immutable; for any thread.
 *
 * @param text what to do, in English words
 * @param reached how long after the first takeoff [s]; empty if it was not reached
 */
public record RecordedGoal(String text, OptionalDouble reached) {}
