package tellosimulator.sim;

import tellosimulator.time.SimTime;

/**
 * A listener that is notified of the inputs, events and steps of a simulation. Called on the
 * simulation thread, at the end of a step or between two steps. Implementations must be quick and
 * must not throw. They may submit commands, which are applied in the next step.
 */
public interface SimListener {

  /**
   * Called between two steps, before an input is applied. Events about the effects of the input
   * follow.
   *
   * @param now the end of the last step
   */
  default void onInput(SimTime now, SimInput input) {}

  /** Called after an event, once the snapshot includes its effects. */
  default void event(SimEvent event) {}

  /** Called at the end of a step, after its events. */
  default void stepped(SimSnapshot snapshot) {}
}
