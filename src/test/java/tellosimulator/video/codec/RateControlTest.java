package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests with simulated frames, each given only by its complexity: the number of bits at QP 0, which
 * halves for every six QP.
 */
class RateControlTest {

  private static final int ROWS = 45;
  private static final int MACROBLOCKS = 60 * ROWS;

  /** Bits at QP 0. Calculated: 50 kB at QP 30 is 400,000 bits times 2^5. */
  private static final double IDR_COMPLEXITY = 12.8e6;

  /** Bits at QP 0 in slow flight. Calculated: 8 kB at QP 30. */
  private static final double P_COMPLEXITY = 2.05e6;

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
    slowFlight(2, framesPerSecond);

    assertThat(slowFlight(3, framesPerSecond))
        .isCloseTo(3.0 * bitsPerSecond, Percentage.withPercentage(10));
  }

  @Test
  void qpIsEvenWhereAllFramesAreAlike() {
    slowFlight(2, 30);
    qps.clear();

    slowFlight(3, 30);

    int least = qps.stream().mapToInt(qp -> qp).min().orElseThrow();
    int most = qps.stream().mapToInt(qp -> qp).max().orElseThrow();
    assertThat(most - least).as("from %d to %d", least, most).isLessThanOrEqualTo(5);
  }

  @Test
  void idrFramesHaveNoHigherQpThanTheFramesBefore() {
    slowFlight(2, 30);
    int idrQp = rate.beginFrame(true);

    assertThat(idrQp).isLessThanOrEqualTo(qps.get(qps.size() - 1));
  }

  @Test
  void aFrameAfterACutDoesNotTakeManyTimesItsShare() {
    slowFlight(2, 30);

    int cut = frame(false, IDR_COMPLEXITY);

    assertThat(cut).isLessThan((int) (2.5e6 / 30 * 4));
    assertThat(qps.get(qps.size() - 1)).as("of its last row").isGreaterThan(rate.beginFrame(false));
  }

  @Test
  void theRateIsKeptAgainSoonAfterACut() {
    slowFlight(2, 30);
    frame(false, IDR_COMPLEXITY);
    slowFlight(1, 30);

    assertThat(slowFlight(2, 30)).isCloseTo(2 * 2.5e6, Percentage.withPercentage(10));
  }

  @Test
  void aNewRateHoldsFromTheNextFrameOn() {
    slowFlight(3, 30);

    rate.setRate(30, 1_000_000);

    assertThat(slowFlight(1, 30)).isCloseTo(1e6, Percentage.withPercentage(15));
  }

  @Test
  void afterARestartTheNextIdrFrameIsAsFine() {
    int first = rate.beginFrame(true);
    frame(true, IDR_COMPLEXITY);
    rate.setRate(30, 2_500_000);

    assertThat(rate.beginFrame(true)).isLessThanOrEqualTo(first + 1);
  }

  @Test
  void unusedBitsAreSavedOnlyInPart() {
    slowFlight(2, 30);
    for (int i = 0; i < 30; i++) {
      frame(false, 1000);
    }

    assertThat(frame(false, 1000)).isLessThan(1000);
    assertThat(frame(false, P_COMPLEXITY))
        .as("and are not all there later")
        .isLessThan((int) (2.5e6 / 30 * 5));
  }

  /** Simulates seconds of slow flight, each a GOP, and returns their bits. */
  private double slowFlight(int seconds, int framesPerSecond) {
    double bits = 0;
    for (int i = 0; i < seconds * framesPerSecond; i++) {
      bits += i % framesPerSecond == 0 ? frame(true, IDR_COMPLEXITY) : frame(false, P_COMPLEXITY);
    }
    return bits;
  }

  private int frame(boolean idr, double complexity) {
    double bits = 0;
    int qp = rate.beginFrame(idr);
    for (int row = 0; row < ROWS; row++) {
      bits += complexity / ROWS * Math.pow(2, -qp / 6.0);
      qps.add(qp);
      qp = rate.rowCoded(row + 1, (int) bits);
    }
    rate.endFrame((int) bits);
    return (int) bits;
  }
}
