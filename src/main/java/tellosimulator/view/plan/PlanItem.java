package tellosimulator.view.plan;

/** Something that can be placed in a room. Immutable. */
sealed interface PlanItem {

  /**
   * Where a drone starts.
   *
   * @param drone its number, from 1
   */
  record Start(int drone) implements PlanItem {}

  /**
   * A mission pad.
   *
   * @param id 1 to 8
   */
  record Pad(int id) implements PlanItem {}

  /**
   * An obstacle.
   *
   * @param index in the order of their numbers, from 0
   */
  record ObstacleItem(int index) implements PlanItem {}

  /**
   * A goal.
   *
   * @param index in the order of their numbers, from 0
   */
  record GoalItem(int index) implements PlanItem {}
}
