package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import tellosimulator.scenery.mesh.Rgb;

class LiveryTest {

  @Test
  void neighborsDiffer() {
    Set<Rgb> colors = new HashSet<>();
    for (int number = 1; number <= 7; number++) {
      colors.add(ofNumber(number).color());
    }
    assertThat(colors).hasSize(7);
    assertThat(ofNumber(8).color()).isEqualTo(ofNumber(1).color());
  }

  @Test
  void theFirstDroneIsWhiteAsTheRealOne() {
    Rgb cover = ofNumber(1).cover();

    assertThat(cover.red()).isGreaterThan(230).isCloseTo(cover.blue(), within(3));
    assertThat(cover.green()).isGreaterThan(230);
    assertThat(ofNumber(2).cover()).isEqualTo(ofNumber(2).color());
  }

  @Test
  void aChosenColorIsThatOfAll() {
    Livery chosen = Livery.of(1, OptionalInt.of(0x123456));

    assertThat(chosen).isEqualTo(new Livery(Rgb.of(0x123456), Rgb.of(0x123456)));
  }

  private static Livery ofNumber(int number) {
    return Livery.of(number, OptionalInt.empty());
  }
}
