package tellosimulator.goal;

import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** An event about the goals of a scenario, told after all other events of the step. */
public sealed interface GoalEvent extends SimEvent {

  /**
   * A drone reached a goal.
   *
   * @param phrase a clause about the drone: {@code reached goal 1 of 3}
   */
  record Reached(SimTime time, int drone, Phrase phrase) implements GoalEvent, SimEvent.ForDrone {

    @Override
    public boolean lacksSubject() {
      return true;
    }
  }

  /**
   * A drone came near a goal, in a way that does not count.
   *
   * @param phrase a clause about the drone: {@code flew through gate A in the wrong direction}
   */
  record Missed(SimTime time, int drone, Phrase phrase) implements GoalEvent, SimEvent.ForDrone {

    @Override
    public boolean lacksSubject() {
      return true;
    }
  }

  /**
   * All goals are reached, or they cannot be reached any more.
   *
   * @param failed whether they cannot
   */
  record Over(SimTime time, Phrase phrase, boolean failed) implements GoalEvent {

    @Override
    public Severity severity() {
      return failed ? Severity.WARNING : Severity.INFORMATION;
    }
  }
}
