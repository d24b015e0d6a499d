package tellosimulator.view.plan;

import java.util.function.Function;

/** An item that can be placed in a room. Immutable. */
sealed interface PlanItem {

  /** Applies the function for this kind of item, and returns its result. */
  <R> R match(
      Function<Start, R> ofStart,
      Function<Pad, R> ofPad,
      Function<ObstacleItem, R> ofObstacle,
      Function<GoalItem, R> ofGoal);

  /**
   * The start of a drone.
   *
   * @param drone the number of the drone, from 1
   */
  record Start(int drone) implements PlanItem {
    @Override
    public <R> R match(
        Function<Start, R> ofStart,
        Function<Pad, R> ofPad,
        Function<ObstacleItem, R> ofObstacle,
        Function<GoalItem, R> ofGoal) {
      return ofStart.apply(this);
    }
  }

  /**
   * A mission pad.
   *
   * @param id the number of the pad, 1 to 8
   */
  record Pad(int id) implements PlanItem {
    @Override
    public <R> R match(
        Function<Start, R> ofStart,
        Function<Pad, R> ofPad,
        Function<ObstacleItem, R> ofObstacle,
        Function<GoalItem, R> ofGoal) {
      return ofPad.apply(this);
    }
  }

  /**
   * An obstacle.
   *
   * @param index the index in the list of obstacles, from 0
   */
  record ObstacleItem(int index) implements PlanItem {
    @Override
    public <R> R match(
        Function<Start, R> ofStart,
        Function<Pad, R> ofPad,
        Function<ObstacleItem, R> ofObstacle,
        Function<GoalItem, R> ofGoal) {
      return ofObstacle.apply(this);
    }
  }

  /**
   * A goal.
   *
   * @param index the index in the list of goals, from 0
   */
  record GoalItem(int index) implements PlanItem {
    @Override
    public <R> R match(
        Function<Start, R> ofStart,
        Function<Pad, R> ofPad,
        Function<ObstacleItem, R> ofObstacle,
        Function<GoalItem, R> ofGoal) {
      return ofGoal.apply(this);
    }
  }
}
