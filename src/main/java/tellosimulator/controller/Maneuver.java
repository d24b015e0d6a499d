package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/**
 * A single action of a drone. It sets the drone's target step by step, and is independent of
 * commands and replies. Each instance is flown once. Confined to the simulation thread.
 */
interface Maneuver {

  /**
   * The inputs of a maneuver.
   *
   * @param motion the drone's motion
   * @param blocked whether the drone lags so far behind that the plan must wait
   * @param onGround whether the drone stands on something
   */
  record Sensed(Motion motion, boolean blocked, boolean onGround) {}

  /** Advances the plan by {@code seconds}, and returns the target for the next step. */
  Setpoint advance(Sensed sensed, double seconds);

  /** Whether the plan has ended. The drone may still have to settle. */
  boolean planned();

  /** Describes the progress, such as {@code 64 of 100 cm flown}. */
  Phrase progress();

  /** Returns the reason why the maneuver cannot be completed; empty if it can. */
  default Optional<Phrase> lost() {
    return Optional.empty();
  }

  /** Whether nothing changes until the next command, so that no simulated time needs to pass. */
  default boolean atRest() {
    return false;
  }

  /** Whether {@code rc} can now steer the drone in addition to the maneuver. */
  default boolean steerable() {
    return true;
  }

  /** Whether the maneuver may leave the range of heights in which the drone hovers. */
  default boolean leavesHoverHeights() {
    return false;
  }
}
