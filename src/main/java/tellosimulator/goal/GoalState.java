package tellosimulator.goal;

/** How one stands with a goal. */
public enum GoalState {
  /** It is reached. */
  DONE,
  /** It can be reached now. */
  ACTIVE,
  /** It cannot be reached yet, or not any more. */
  LATER
}
