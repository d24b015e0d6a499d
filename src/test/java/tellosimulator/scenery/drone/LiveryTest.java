package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import tellosimulator.scenery.Rgb;

class LiveryTest {

  @Test
  void neighboursDiffer() {
    Set<Rgb> colors = new HashSet<>();
    for (int number = 1; number <= 7; number++) {
      colors.add(Livery.of(number));
    }
    assertThat(colors).hasSize(7);
    assertThat(Livery.of(8)).isEqualTo(Livery.of(1));
  }

  @Test
  void theFirstDroneIsWhiteAsTheRealOne() {
    Rgb cover = Livery.cover(1);

    assertThat(cover.red()).isGreaterThan(230).isCloseTo(cover.blue(), within(3));
    assertThat(cover.green()).isGreaterThan(230);
    assertThat(Livery.cover(2)).isEqualTo(Livery.of(2));
  }
}
