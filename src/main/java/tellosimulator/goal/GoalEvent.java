package tellosimulator.goal;

import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * An event about the goals of a scenario. Reported after all other events of the step, except that
 * a failure caused by an event is reported directly after that event.
 */
public sealed interface GoalEvent extends SimEvent {

  /**
   * A drone reached a goal.
   *
   * @param phrase a clause about the drone, such as {@code reached goal 1 of 3}
   */
  record Reached(SimTime time, int drone, Phrase phrase) implements GoalEvent, SimEvent.ForDrone {

    @Override
    public boolean lacksSubject() {
      return true;
    }
  }

  /**
   * A drone nearly reached a goal.
   *
   * @param phrase a clause about the drone, such as {@code flew through gate A in the wrong
   *     direction}
   */
  record Missed(SimTime time, int drone, Phrase phrase) implements GoalEvent, SimEvent.ForDrone {

    @Override
    public boolean lacksSubject() {
      return true;
    }
  }

  /** Points were lost. */
  record Penalty(SimTime time, Phrase phrase) implements GoalEvent, SimEvent.Warning {}

  /**
   * The attempt is over: all goals have been reached, or the remaining ones can no longer be
   * reached.
   *
   * @param failed whether some goals have not been reached
   */
  record Over(SimTime time, Phrase phrase, boolean failed) implements GoalEvent {

    @Override
    public Severity severity() {
      return failed ? Severity.WARNING : Severity.INFORMATION;
    }
  }
}
