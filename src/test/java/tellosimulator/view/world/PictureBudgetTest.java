package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PictureBudgetTest {

  private static final long MS = 1_000_000;

  private final PictureBudget budget = new PictureBudget();

  @Test
  void theFirstPictureMayBeTakenAtOnce() {
    assertThat(budget.allows(0)).isTrue();
    assertThat(budget.allows(-5)).isTrue();
  }

  @Test
  void quickPicturesComeTenTimesASecond() {
    budget.taken(0, 2 * MS);

    assertThat(budget.allows(99 * MS)).isFalse();
    assertThat(budget.allows(100 * MS)).isTrue();
  }

  @Test
  void slowPicturesTakeAFourthOfTheTime() {
    budget.taken(0, 80 * MS);

    assertThat(budget.allows(319 * MS)).isFalse();
    assertThat(budget.allows(320 * MS)).isTrue();
  }
}
