package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ShadowTest {

  @Test
  void itShrinksAndFadesWithHeight() {
    Shadow last = Shadow.at(0);
    for (double height = 0.1; height < 10; height += 0.1) {
      Shadow higher = Shadow.at(height);
      assertThat(higher.radius()).isLessThan(last.radius());
      assertThat(higher.opacity()).isLessThan(last.opacity());
      last = higher;
    }
  }

  @Test
  void oneSeesItFromAnyHeight() {
    assertThat(Shadow.at(200).opacity()).isGreaterThan(0.2);
    assertThat(Shadow.at(200).radius()).isGreaterThan(0.07);
  }

  @Test
  void onTheFloorItIsALittleLargerThanTheDrone() {
    assertThat(Shadow.at(0).radius()).isBetween(0.1, 0.2);
    assertThat(Shadow.at(-1)).isEqualTo(Shadow.at(0));
  }
}
