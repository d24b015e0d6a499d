package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class ItemPropertyTest {

  private static final FloorPlan PLAN =
      FloorPlans.of(Arena.DEFAULT, List.of(new Pose(Vec3.ZERO, Attitude.LEVEL)))
          .with(obstacle("box", new Shape.Box(0.4, 0.6, 0.5)))
          .with(obstacle("cylinder", new Shape.Cylinder(0.2, 1)))
          .with(obstacle("ring", new Shape.Ring(0.4, 0.05, 0.6)))
          .with(obstacle("frame", new Shape.Frame(0.8, 0.6, 0.05, 0.9)))
          .with(MissionPad.onFloor(1, new Vec3(1, -1, 0), 0))
          .with(new MissionPad(2, Surface.FRONT_WALL, 0.3, 1.2, 0));

  private static Obstacle obstacle(String name, Shape shape) {
    return new Obstacle(name, shape, new Vec3(-1, 1, 0), 0.5, ObstacleAppearance.DEFAULT);
  }

  private static Stream<PlanItem> items() {
    return PLAN.items().stream();
  }

  /** Each number can be changed by itself, and is read back. */
  @ParameterizedTest
  @MethodSource("items")
  void aChangedNumberIsReadBackAndNothingElseChanges(PlanItem item) {
    for (ItemProperty property : properties(item)) {
      double wanted = property.of(PLAN, item).orElseThrow() + 10;

      FloorPlan changed = property.with(PLAN, item, wanted);

      assertThat(property.of(changed, item).orElseThrow())
          .as("%s of %s", property, item)
          .isCloseTo(wanted, within(0.05));
      for (ItemProperty other : properties(item)) {
        if (other != property) {
          assertThat(other.of(changed, item))
              .as("%s of %s after %s", other, item, property)
              .isEqualTo(other.of(PLAN, item));
        }
      }
      PLAN.items().stream()
          .filter(each -> !each.equals(item))
          .forEach(each -> assertThat(changed.placement(each)).isEqualTo(PLAN.placement(each)));
    }
  }

  private static List<ItemProperty> properties(PlanItem item) {
    return Arrays.stream(ItemProperty.values())
        .filter(property -> property.of(PLAN, item).isPresent())
        .toList();
  }

  @Test
  void eachKindHasItsOwnNumbers() {
    assertThat(properties(new ObstacleItem(0)))
        .containsExactly(
            ItemProperty.X,
            ItemProperty.Y,
            ItemProperty.ELEVATION,
            ItemProperty.HEADING,
            ItemProperty.DEPTH,
            ItemProperty.WIDTH,
            ItemProperty.HEIGHT);
    assertThat(properties(new ObstacleItem(3)))
        .contains(ItemProperty.WIDTH, ItemProperty.OPENING, ItemProperty.MIDDLE)
        .doesNotContain(ItemProperty.HEIGHT, ItemProperty.DIAMETER);
    assertThat(properties(new Pad(1)))
        .containsExactly(ItemProperty.X, ItemProperty.Y, ItemProperty.HEADING);
    assertThat(properties(new Pad(2)))
        .containsExactly(ItemProperty.ALONG, ItemProperty.MIDDLE_OF_PAD);
    assertThat(properties(new Start(1)))
        .containsExactly(ItemProperty.X, ItemProperty.Y, ItemProperty.HEADING);
  }

  /** An opening of 160 cm in a beam of 5 cm needs its middle at 85 cm. */
  @Test
  void aLargerRingIsRaisedAsFarAsItMust() {
    ObstacleItem ring = new ObstacleItem(2);

    FloorPlan changed = ItemProperty.DIAMETER.with(PLAN, ring, 160);

    assertThat(ItemProperty.MIDDLE.of(changed, ring)).hasValue(85);
    assertThat(ItemProperty.MIDDLE.of(ItemProperty.MIDDLE.with(PLAN, ring, 10), ring)).hasValue(45);
  }
}
