package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Shape;

/** The positions of numbers on the plan: at grid lines, and far enough apart to be readable. */
class PlanPainterTest {

  @ParameterizedTest
  @CsvSource({"0.4, 113, 0.4", "0.4, 100, 0.8", "0.1, 100, 0.5", "0.1, 20, 5", "1, 10, 5"})
  void numbersAreAtLinesOfTheGrid(double grid, double pixels, double step) {
    assertThat(PlanPainter.numberStep(grid, pixels)).isEqualTo(step);
  }

  @Test
  void aGateSaysHowHighItsOpeningIsAndAnythingElseHowHighItReaches() {
    ObstacleAppearance cover = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    Obstacle gate = new Obstacle("A", new Shape.Ring(0.4, 0.03, 1.2), Vec3.ZERO, 0, cover);
    Obstacle box = new Obstacle("box 1", new Shape.Box(1, 1, 1), Vec3.ZERO, 0, cover);

    assertThat(PlanPainter.height(gate)).isEqualTo(" · z 120");
    assertThat(PlanPainter.height(box)).isEqualTo(" · h 100");
    assertThat(PlanPainter.height(box.movedTo(Vec3.UP, 0))).isEqualTo(" · z 100–200");
  }
}
