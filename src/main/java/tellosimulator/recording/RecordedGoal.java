package tellosimulator.recording;

import java.util.OptionalDouble;
import tellosimulator.words.Phrase;

/**
 * A goal of the scenario that was flown. Immutable.
 *
 * @param phrase the description of the goal
 * @param reached when the goal was reached, in simulated seconds since the simulation began; empty
 *     if it was not reached
 */
public record RecordedGoal(Phrase phrase, OptionalDouble reached) {}
