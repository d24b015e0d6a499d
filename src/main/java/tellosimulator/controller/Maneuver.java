package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/**
 * One thing that a drone does: it says, step by step, where the drone shall be. Knows nothing of
 * who asked for it, and nothing of replies. For one drone and the simulation thread.
 */
interface Maneuver {

  /**
   * What a maneuver may look at.
   *
   * @param motion how the drone moves
   * @param blocked whether it hangs so far behind that the plan must wait
   * @param onGround whether it stands on something
   */
  record Sensed(Motion motion, boolean blocked, boolean onGround) {}

  /** The target for the next step. */
  Setpoint advance(Sensed sensed, double seconds);

  /** Whether the plan has come to its end; the drone may still have to balance out. */
  boolean planned();

  /** How far it is, in plain words: {@code 64 of 100 cm flown}. */
  Phrase progress();

  /** Why it cannot be flown to its end, if that is so. */
  default Optional<Phrase> lost() {
    return Optional.empty();
  }

  /** Whether nothing changes until the next command, so that no time need pass. */
  default boolean atRest() {
    return false;
  }

  /** Whether {@code rc} may steer on top of it now. */
  default boolean steerable() {
    return true;
  }

  /** Whether it may leave the heights in which a drone hovers. */
  default boolean leavesHoverHeights() {
    return false;
  }
}
