package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.junit.TelloAssertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SimulationAssertTest {

  private static final String SCENARIO =
      """
      goals:
        - reach: {at: [0, 0, 30], points: 10}
        - land: {at: [100, 0], points: 5}
      scoring: {refused: 0.5}
      """;

  @TempDir private Path folder;

  @Test
  void pointsAreExpectedAndExplained() throws IOException {
    Path file = Files.writeString(folder.resolve("points.yaml"), SCENARIO);
    try (TelloSimulator simulator = TelloSimulator.start(file.toString())) {
      ScriptedOperator.fly(simulator.drone(), "command", "takeoff", "forward 5000", "land");
      TelloSimulation simulation = simulator.simulation();

      assertThat(simulation).hasScored(9.5);
      assertThatThrownBy(() -> assertThat(simulation).hasScored(15))
          .isInstanceOf(AssertionError.class)
          .hasMessageStartingWith("expected 15 points, but scored 9.5 of 15 points\n  +10 at ")
          .hasMessageContaining("s: reached goal 1 of 2: reach x 0, y 0, z 30 cm\n  -0.5 at ")
          .hasMessageContaining("s: drone 1 refused `forward 5000`: ");
      Assertions.assertThat(simulation.goals().toString()).contains("; score: 9.5 of 15 points");
    }
  }

  @Test
  void withoutPointsThereIsNothingToExpect() {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      assertThatThrownBy(() -> assertThat(simulator.simulation()).hasScored(0))
          .isInstanceOf(IllegalStateException.class)
          .hasMessage("the scenario has no points to score");
    }
  }
}
