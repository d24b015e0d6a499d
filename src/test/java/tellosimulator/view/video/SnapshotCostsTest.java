package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SnapshotCostsTest {

  private static final long MS = 1_000_000;

  private final SnapshotCosts costs = new SnapshotCosts();

  @Test
  void twoPicturesSayNothing() {
    costs.add(MS);
    costs.add(MS);

    assertThat(costs.known()).isFalse();
    assertThat(costs.cheap()).isFalse();
  }

  @Test
  void oneExceptionDecidesNothing() {
    costs.add(300 * MS);
    costs.add(2 * MS);
    costs.add(3 * MS);

    assertThat(costs.cheap()).isTrue();
    assertThat(costs.median()).isEqualTo(3 * MS);
  }

  @Test
  void eightMillisecondsAreCheapAndMoreAreNot() {
    add(3, 8 * MS);
    assertThat(costs.cheap()).isTrue();

    add(SnapshotCosts.MOST, 8 * MS + 1);
    assertThat(costs.cheap()).isFalse();
  }

  @Test
  void theLastPicturesCountAndNotTheFirst() {
    add(100, 20 * MS);
    assertThat(costs.cheap()).isFalse();

    add(SnapshotCosts.MOST / 2, MS);
    assertThat(costs.cheap()).as("the median is still that of the others").isFalse();
    costs.add(MS);
    assertThat(costs.cheap()).isTrue();
  }

  @Test
  void forgettingBeginsAnew() {
    add(10, MS);
    costs.forget();

    assertThat(costs.known()).isFalse();
    assertThat(costs.median()).isZero();
  }

  private void add(int count, long cost) {
    for (int i = 0; i < count; i++) {
      costs.add(cost);
    }
  }
}
