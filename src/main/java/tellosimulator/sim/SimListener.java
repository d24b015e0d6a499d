package tellosimulator.sim;

import tellosimulator.time.SimTime;

/**
 * Is told what happens in a simulation. Called on the simulation thread, last in a step: it must be
 * quick, and must not throw. It may submit commands; they are taken in the next step.
 */
public interface SimListener {

  /**
   * An input is taken next, between two steps; events that tell its effects follow.
   *
   * @param now the end of the last step
   */
  default void taken(SimTime now, SimInput input) {}

  /** Something happened. */
  default void event(SimEvent event) {}

  /** A step was completed. */
  default void stepped(SimSnapshot snapshot) {}
}
