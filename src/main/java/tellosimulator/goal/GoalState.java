package tellosimulator.goal;

/**
 * The state of a goal. The states are in order of precedence: a place that several goals share is
 * shown in the first of their states.
 */
public enum GoalState {
  /** The goal can be reached now. */
  ACTIVE,
  /** The goal cannot be reached yet, or can no longer be reached. */
  LATER,
  /** The goal has been reached. */
  DONE
}
