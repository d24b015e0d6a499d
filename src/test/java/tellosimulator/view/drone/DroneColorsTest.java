package tellosimulator.view.drone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

class DroneColorsTest {

  @Test
  void neighboursDiffer() {
    Set<Color> colors = new HashSet<>();
    for (int number = 1; number <= 7; number++) {
      colors.add(DroneColors.of(number));
    }
    assertThat(colors).hasSize(7);
    assertThat(DroneColors.of(8)).isEqualTo(DroneColors.of(1));
  }

  @Test
  void theFirstDroneIsWhiteAsTheRealOne() {
    assertThat(DroneColors.cover(1).getSaturation()).isLessThan(0.05);
    assertThat(DroneColors.cover(1).getBrightness()).isGreaterThan(0.9);
    assertThat(DroneColors.cover(2)).isEqualTo(DroneColors.of(2));
  }
}
