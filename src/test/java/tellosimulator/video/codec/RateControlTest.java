package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures are only numbers here: what each would take at QP 0; 6 more halve that. */
class RateControlTest {

  private static final int ROWS = 45;
  private static final int MACROBLOCKS = 60 * ROWS;

  /** At QP 0 [bit]. Calculated: 50 kB at QP 30 is 400,000 bits times 2^5. */
  private static final double KEY = 12.8e6;

  /** At QP 0 [bit]: slow flight. Calculated: 8 kB at QP 30. */
  private static final double OTHER = 2.05e6;

  private final RateControl rate = new RateControl(MACROBLOCKS, ROWS);
  private final List<Integer> qps = new ArrayList<>();

  @BeforeEach
  void asTheDroneDoes() {
    rate.setRate(30, 2_500_000);
  }

  @ParameterizedTest
  @CsvSource({
    "30, 1000000",
    "30, 2500000",
    "30, 5000000",
    "15, 1000000",
    "15, 4000000",
    "5, 1000000",
    "5, 2000000"
  })
  void theRateIsKept(int framesPerSecond, int bitsPerSecond) {
    rate.setRate(framesPerSecond, bitsPerSecond);
    flight(2, framesPerSecond);

    assertThat(flight(3, framesPerSecond))
        .isCloseTo(3.0 * bitsPerSecond, Percentage.withPercentage(10));
  }

  @Test
  void qualityIsEvenWhereAllPicturesAreAlike() {
    flight(2, 30);
    qps.clear();

    flight(3, 30);

    int least = qps.stream().mapToInt(qp -> qp).min().orElseThrow();
    int most = qps.stream().mapToInt(qp -> qp).max().orElseThrow();
    assertThat(most - least).as("from %d to %d", least, most).isLessThanOrEqualTo(5);
  }

  @Test
  void keyPicturesAreAtLeastAsFineAsThoseAfterThem() {
    flight(2, 30);
    int keyQp = rate.begin(true);

    assertThat(keyQp).isLessThanOrEqualTo(qps.get(qps.size() - 1));
  }

  @Test
  void pictureAfterCutDoesNotTakeManyTimesItsShare() {
    flight(2, 30);

    int cut = picture(false, KEY);

    assertThat(cut).isLessThan((int) (2.5e6 / 30 * 4));
    assertThat(qps.get(qps.size() - 1)).as("of its last row").isGreaterThan(rate.begin(false));
  }

  @Test
  void theRateIsKeptAgainSoonAfterCut() {
    flight(2, 30);
    picture(false, KEY);
    flight(1, 30);

    assertThat(flight(2, 30)).isCloseTo(2 * 2.5e6, Percentage.withPercentage(10));
  }

  @Test
  void anotherRateHoldsFromTheNextPictureOn() {
    flight(3, 30);

    rate.setRate(30, 1_000_000);

    assertThat(flight(1, 30)).isCloseTo(1e6, Percentage.withPercentage(15));
  }

  @Test
  void afterAPictureThatNobodyGetsTheNextKeyPictureIsAsFine() {
    int first = rate.begin(true);
    picture(true, KEY);
    rate.setRate(30, 2_500_000);

    assertThat(rate.begin(true)).isLessThanOrEqualTo(first + 1);
  }

  @Test
  void bitsThatNobodyNeedsAreNotUsed() {
    flight(2, 30);
    for (int i = 0; i < 30; i++) {
      picture(false, 1000);
    }

    assertThat(picture(false, 1000)).isLessThan(1000);
    assertThat(picture(false, OTHER))
        .as("and are not all there later")
        .isLessThan((int) (2.5e6 / 30 * 5));
  }

  /** Seconds of slow flight with a key picture each; what they took. */
  private double flight(int seconds, int framesPerSecond) {
    double bits = 0;
    for (int i = 0; i < seconds * framesPerSecond; i++) {
      bits += i % framesPerSecond == 0 ? picture(true, KEY) : picture(false, OTHER);
    }
    return bits;
  }

  private int picture(boolean key, double atZero) {
    double bits = 0;
    int qp = rate.begin(key);
    for (int row = 0; row < ROWS; row++) {
      bits += atZero / ROWS * Math.pow(2, -qp / 6.0);
      qps.add(qp);
      qp = rate.row(row + 1, (int) bits);
    }
    rate.end((int) bits);
    return (int) bits;
  }
}
