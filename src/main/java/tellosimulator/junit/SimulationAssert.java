package tellosimulator.junit;

import org.assertj.core.api.AbstractAssert;
import tellosimulator.goal.Score;

/**
 * Assertions about the points for the goals of the scenario, as they are now. {@link
 * TelloSimulation#goals} provides the same facts without AssertJ.
 */
public final class SimulationAssert extends AbstractAssert<SimulationAssert, TelloSimulation> {

  SimulationAssert(TelloSimulation simulation) {
    super(simulation, SimulationAssert.class);
  }

  /**
   * Asserts the number of points, exact to a hundredth.
   *
   * @throws IllegalStateException if the scenario has no points
   */
  public SimulationAssert hasScored(double points) {
    ScoreStatus score =
        actual
            .goals()
            .score()
            .orElseThrow(() -> new IllegalStateException("the scenario has no points to score"));
    if (Math.abs(score.points() - points) >= 0.005) {
      failWithMessage("expected %s, but scored %s", Score.points(points), score);
    }
    return this;
  }
}
