package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;

class AlignmentTest {

  /** A box of 40 by 60 cm with its middle at (1, 1), and one of 20 by 20 cm at (-1, 0). */
  private static final FloorPlan PLAN =
      FloorPlans.of(Arena.DEFAULT, List.of(new Pose(Vec3.ZERO, Attitude.LEVEL)))
          .with(box("large", 0.4, 0.6, new Vec3(1, 1, 0)))
          .with(box("small", 0.2, 0.2, new Vec3(-1, 0, 0)));

  private static final ObstacleItem LARGE = new ObstacleItem(0);
  private static final ObstacleItem SMALL = new ObstacleItem(1);

  private static Obstacle box(String name, double depth, double width, Vec3 foot) {
    return new Obstacle(
        name, new Shape.Box(depth, width, 0.5), foot, 0, ObstacleAppearance.DEFAULT);
  }

  /** The large one's edges are at x 0.8 and 1.2, and at y 0.7 and 1.3. */
  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          FRONT,  1.1, 0
          BACK,   0.9, 0
          LEFT,   -1,  1.2
          RIGHT,  -1,  0.8
          ROW,    1,   0
          COLUMN, -1,  1
          """)
  void theOthersMoveToTheLineOfTheLastOne(Alignment alignment, double x, double y) {
    FloorPlan aligned = alignment.aligned(PLAN, List.of(SMALL, LARGE));

    assertThat(aligned.placement(LARGE)).isEqualTo(PLAN.placement(LARGE));
    assertThat(aligned.placement(SMALL).place().x()).isCloseTo(x, within(1e-9));
    assertThat(aligned.placement(SMALL).place().y()).isCloseTo(y, within(1e-9));
    assertThat(aligned.placement(new Start(1))).isEqualTo(PLAN.placement(new Start(1)));
  }
}
