package tellosimulator.sim;

/**
 * Is told what happens in a simulation. Called on the simulation thread, last in a step: it must be
 * quick, and must not throw. It may submit commands; they are taken in the next step.
 */
public interface SimListener {

  /** Something happened. */
  default void event(SimEvent event) {}

  /** A step was completed. */
  default void stepped(SimSnapshot snapshot) {}
}
