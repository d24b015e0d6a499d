package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.plan.PlacementProblem.LAST_DRONE;
import static tellosimulator.view.plan.PlacementProblem.NAMED_BY_FAULT;
import static tellosimulator.view.plan.PlacementProblem.NAMED_BY_GOAL;
import static tellosimulator.view.plan.PlacementProblem.OUTSIDE;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

class PlacementProblemTest {

  /** Two drones in the default room, from -2.5 to 2.5 m, with a table of 40 by 100 cm. */
  private static final FloorPlan LAYOUT =
      FloorPlans.of(
          Arena.DEFAULT
              .withObstacles(List.of(item(new Shape.Box(0.4, 1, 0.5), new Vec3(1, 0, 0))))
              .withPads(List.of(MissionPad.onFloor(1, new Vec3(0, 1, 0), 0))),
          List.of(
              new Pose(Vec3.ZERO, Attitude.LEVEL), new Pose(new Vec3(0, 1, 0), Attitude.LEVEL)));

  private static Obstacle item(Shape shape, Vec3 foot) {
    return new Obstacle("item", shape, foot, 0, ObstacleAppearance.DEFAULT);
  }

  /**
   * Half of the table's depth is 20 cm, a drone's radius 8.7 cm. A file may exceed the room by half
   * a millimetre for rounding, which is no problem here either.
   */
  @ParameterizedTest
  @CsvSource(
      nullValues = "-",
      value = {
        "2.3,   0, -",
        "2.3005, 0, -",
        "2.31,  0, OUTSIDE",
        "0.288, 0, -",
        "0.286, 0, ON_START",
        "0,     1, ON_START",
      })
  void anObstacleStaysInTheRoomAndOffStarts(double x, double y, PlacementProblem problem) {
    assertThat(problem(new ObstacleItem(0), x, y)).isEqualTo(problem);
  }

  @Test
  void aTurnedObstacleNeedsMoreRoom() {
    FloorPlan turned =
        LAYOUT.with(new ObstacleItem(0), new Placement(new Vec3(2.3, 0, 0), Math.PI / 2));

    assertThat(PlacementProblem.problem(turned, new ObstacleItem(0)))
        .contains(PlacementProblem.OUTSIDE);
  }

  @ParameterizedTest
  @CsvSource(
      nullValues = "-",
      value = {
        "2.413, -2.413, -",
        "2.414, 0,      OUTSIDE",
        "0,     0.826,  -",
        "0,     0.827,  ON_DRONE",
        "1,     0,      IN_OBSTACLE",
        "0.714, 0,      IN_OBSTACLE",
        "0.712, 0,      -",
      })
  void aStartIsFree(double x, double y, PlacementProblem problem) {
    assertThat(problem(new Start(1), x, y)).isEqualTo(problem);
  }

  @Test
  void aDroneMayStartOnAPadAndBelowAGate() {
    assertThat(problem(new Pad(1), 0, 0)).isNull();
    Shape ring = new Shape.Ring(0.4, 0.05, 1.5);
    FloorPlan gate = LAYOUT.with(item(ring, new Vec3(0, 0.3, 0)));

    assertThat(PlacementProblem.problem(gate, new ObstacleItem(1))).isEmpty();
    assertThat(
            PlacementProblem.problem(
                gate.with(new ObstacleItem(1), new Placement(Vec3.ZERO, 0)), new ObstacleItem(1)))
        .as("its post")
        .contains(PlacementProblem.ON_START);
  }

  @Test
  void nothingIsHigherThanTheRoom() {
    double ceiling = Arena.DEFAULT.room().height();
    assertThat(DroneSpec.COLLIDER.height()).isLessThan(ceiling);

    FloorPlan high = LAYOUT.with(item(new Shape.Cylinder(0.1, ceiling + 0.01), new Vec3(-1, 0, 0)));

    assertThat(PlacementProblem.problem(high, new ObstacleItem(1)))
        .contains(PlacementProblem.TOO_HIGH);
  }

  private static PlacementProblem problem(PlanItem item, double x, double y) {
    Placement placement = new Placement(new Vec3(x, y, 0), 0);
    return PlacementProblem.problem(LAYOUT.with(item, placement), item).orElse(null);
  }

  @Test
  void aGoalStaysInTheRoomAndWhatItNamesStaysThere() {
    Goal outside =
        new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, Room.DEFAULT.height() + 1), 1));
    FloorPlan wrong = LAYOUT.with(outside);
    assertThat(PlacementProblem.problem(wrong, new GoalItem(0))).contains(OUTSIDE);

    FloorPlan asked = LAYOUT.with(new Goal.LandOn(Terms.ANY, 1));
    assertThat(PlacementProblem.problemWithGoals(asked, asked.without(new Pad(1))))
        .contains(NAMED_BY_GOAL);
    FloorPlan both = asked.without(List.of(new Pad(1), new GoalItem(0)));
    assertThat(PlacementProblem.problemWithGoals(asked, both)).isEmpty();
  }

  @Test
  void aDroneStaysThatIsTheLastOneOrHasAGoalOrMaybeAFault() {
    Goal goal = new Goal.Land(Terms.of(2), new GoalRegion(Vec3.ZERO, 0.3));
    FloorPlan asked = LAYOUT.with(goal);
    List<PlanItem> first = List.of(new Start(1));
    List<PlanItem> second = List.of(new Start(2));

    assertThat(PlacementProblem.problemWithout(asked, first, false)).isEmpty();
    assertThat(PlacementProblem.problemWithout(asked, second, false)).contains(NAMED_BY_GOAL);
    assertThat(PlacementProblem.problemWithout(asked, first, true)).contains(NAMED_BY_FAULT);
    assertThat(PlacementProblem.problemWithout(LAYOUT, List.of(new Start(1), new Start(2)), false))
        .contains(LAST_DRONE);
  }
}
