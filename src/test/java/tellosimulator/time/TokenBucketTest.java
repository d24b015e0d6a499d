package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TokenBucketTest {

  private static final long SECOND = 1_000_000_000;

  private long now;

  @Test
  void aBurstPassesAndThenASteadyRate() {
    TokenBucket bucket = new TokenBucket(10, 3, () -> now);

    assertThat(taken(bucket, 5, 0)).isEqualTo(3);
    assertThat(taken(bucket, 5, SECOND / 10 - 1)).isZero();
    assertThat(taken(bucket, 5, SECOND / 10)).isEqualTo(1);
    assertThat(taken(bucket, 5, SECOND * 3 / 10)).isEqualTo(2);
  }

  @Test
  void aLongRestFillsItOnlyToItsBurst() {
    TokenBucket bucket = new TokenBucket(10, 3, () -> now);

    assertThat(taken(bucket, 10, SECOND * 3600)).isEqualTo(3);
  }

  @Test
  void manyTriesInBetweenCostNothing() {
    TokenBucket bucket = new TokenBucket(10, 1, () -> now);
    int taken = 0;
    for (int i = 0; i <= 10_000; i++) {
      taken += taken(bucket, 1, i * SECOND / 10_000);
    }

    assertThat(taken).isBetween(10, 11); // the first one, and ten in a second
  }

  private int taken(TokenBucket bucket, int tries, long nanos) {
    now = nanos;
    int taken = 0;
    for (int i = 0; i < tries; i++) {
      taken += bucket.tryTake() ? 1 : 0;
    }
    return taken;
  }
}
