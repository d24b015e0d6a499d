package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the plan has numbers: at lines of its grid, and no nearer than they can be read. */
class PlanPainterTest {

  @ParameterizedTest
  @CsvSource({"0.4, 113, 0.4", "0.4, 100, 0.8", "0.1, 100, 0.5", "0.1, 20, 5", "1, 10, 5"})
  void numbersAreAtLinesOfTheGrid(double grid, double pixels, double step) {
    assertThat(PlanPainter.numberStep(grid, pixels)).isEqualTo(step);
  }
}
