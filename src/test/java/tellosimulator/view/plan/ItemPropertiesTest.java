package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.ItemProperty.Choice;
import tellosimulator.view.plan.ItemProperty.Measure;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class ItemPropertiesTest {

  private static final GoalRegion REGION = new GoalRegion(new Vec3(0.5, 0.5, 1), 0.3);

  private static final FloorPlan PLAN =
      FloorPlans.of(Arena.DEFAULT, List.of(new Pose(Vec3.ZERO, Attitude.LEVEL)))
          .with(obstacle("box", new Shape.Box(0.4, 0.6, 0.5)))
          .with(obstacle("cylinder", new Shape.Cylinder(0.2, 1)))
          .with(obstacle("ring", new Shape.Ring(0.4, 0.05, 0.6)))
          .with(obstacle("frame", new Shape.Frame(0.8, 0.6, 0.05, 0.9)))
          .with(MissionPad.onFloor(1, new Vec3(1, -1, 0), 0))
          .with(new MissionPad(2, Surface.FRONT_WALL, 0.3, 1.2, 0))
          .with(new Goal.Reach(Terms.ANY, REGION))
          .with(new Goal.Hover(Terms.of(1), REGION, 5))
          .with(new Goal.Pass(Terms.ANY, "ring", Goal.Direction.ALONG))
          .with(new Goal.Land(Terms.ANY, REGION))
          .with(new Goal.LandOn(Terms.ANY, 1))
          .with(new Goal.See(Terms.ANY, new Goal.NumberedPad(2)));

  private static Obstacle obstacle(String name, Shape shape) {
    return new Obstacle(name, shape, new Vec3(-1, 1, 0), 0.5, ObstacleAppearance.DEFAULT);
  }

  private static Stream<PlanItem> items() {
    return PLAN.items().stream();
  }

  /** Each number can be changed independently, and is read back. */
  @ParameterizedTest
  @MethodSource("items")
  void aChangedNumberIsReadBackAndNothingElseChanges(PlanItem item) {
    for (Measure measure : measures(PLAN, item)) {
      double wanted = measure.value() + 10;

      FloorPlan changed = measure.with().apply(wanted).plan();

      for (Measure after : measures(changed, item)) {
        boolean same = after.key().equals(measure.key());
        assertThat(after.value())
            .as("%s of %s after %s", after.key(), item, measure.key())
            .isCloseTo(same ? wanted : value(PLAN, item, after.key()), within(same ? 0.05 : 0));
      }
      PLAN.items().stream()
          .filter(each -> !each.equals(item) && !PLAN.namesAnother(each))
          .forEach(each -> assertThat(changed.placement(each)).isEqualTo(PLAN.placement(each)));
    }
  }

  private static List<ItemProperty<?>> properties(FloorPlan plan, PlanItem item) {
    return ItemProperties.of(plan, item, drone -> Color.RED);
  }

  private static List<Measure> measures(FloorPlan plan, PlanItem item) {
    return properties(plan, item).stream()
        .filter(Measure.class::isInstance)
        .map(Measure.class::cast)
        .toList();
  }

  private static Measure measure(FloorPlan plan, PlanItem item, String key) {
    return measures(plan, item).stream()
        .filter(measure -> measure.key().equals(key))
        .findFirst()
        .orElseThrow();
  }

  private static double value(FloorPlan plan, PlanItem item, String key) {
    return measure(plan, item, key).value();
  }

  private static List<String> keys(PlanItem item) {
    return properties(PLAN, item).stream().map(ItemProperty::key).toList();
  }

  @Test
  void eachKindHasItsOwnProperties() {
    assertThat(keys(new ObstacleItem(0)))
        .containsExactly(
            "name", "x", "y", "elevation", "heading", "depth", "width", "height", "color");
    assertThat(keys(new ObstacleItem(3)))
        .contains("width", "opening", "middle")
        .doesNotContain("height", "diameter");
    assertThat(keys(new Pad(1))).containsExactly("number", "x", "y", "heading");
    assertThat(keys(new Pad(2))).containsExactly("number", "along", "middle-of-pad");
    assertThat(keys(new Start(1))).containsExactly("number", "x", "y", "heading", "color");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          0 | number drone x y height-of-goal radius points
          1 | number drone x y height-of-goal radius seconds points
          2 | number gate direction drone points
          3 | number drone x y radius points
          4 | number pad drone points
          """)
  void eachKindOfGoalHasItsOwnProperties(int index, String keys) {
    assertThat(keys(new GoalItem(index))).containsExactly(keys.split(" "));
  }

  /** An opening of 160 cm in a beam of 5 cm has its middle at 85 cm or higher. */
  @Test
  void aLargerRingIsRaisedAsFarAsItMust() {
    ObstacleItem ring = new ObstacleItem(2);

    FloorPlan wider = measure(PLAN, ring, "diameter").with().apply(160.0).plan();
    FloorPlan lower = measure(PLAN, ring, "middle").with().apply(10.0).plan();

    assertThat(value(wider, ring, "middle")).isEqualTo(85);
    assertThat(value(lower, ring, "middle")).isEqualTo(45);
  }

  /** The numbers that the panel accepts for a shape are those that the shape accepts. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void theSmallestObstaclesCanBeMade(int index) {
    ObstacleItem item = new ObstacleItem(index);

    for (Measure measure : measures(PLAN, item)) {
      assertThat(measure.with().apply(measure.range().least()).plan().has(item)).isTrue();
    }
  }

  @Test
  void aRenumberedPadIsStillTheSelectedOne() {
    Choice<?> number =
        (Choice<?>) properties(PLAN, new Pad(1)).get(0); // 2 is the id of the other pad

    assertThat(number.options()).isEqualTo(List.of(1, 3, 4, 5, 6, 7, 8));
    assertThat(renumbered(new Pad(1), 5).item()).isEqualTo(new Pad(5));
    assertThat(renumbered(new Pad(1), 5).plan().has(new Pad(1))).isFalse();
    assertThat(renumbered(new GoalItem(0), 3).item()).isEqualTo(new GoalItem(2));
    assertThat(renumbered(new GoalItem(0), 3).plan().goal(new GoalItem(2)))
        .isEqualTo(PLAN.goal(new GoalItem(0)));
  }

  @SuppressWarnings("unchecked") // numbers are integers
  private static PlanChange renumbered(PlanItem item, int number) {
    return ((Choice<Integer>) properties(PLAN, item).get(0)).with().apply(number);
  }
}
