package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TimeSeriesTest {

  private final TimeSeries ring = new TimeSeries();

  @Test
  void samplesThatComeTooSoonAreLeftOut() {
    for (int i = 0; i <= 100; i++) {
      ring.add(i * 0.01, i);
    }

    assertThat(ring.size()).isEqualTo(5); // 0, 0.25, 0.5, 0.75 and 1 s
    assertThat(ring.value(1)).isEqualTo(25);
  }

  @Test
  void theOldestMakeRoom() {
    for (int i = 0; i < 10_000; i++) {
      ring.add(i, i);
    }

    assertThat(ring.size()).isEqualTo(242); // 60 s at 4 a second, both ends, one beyond
    assertThat(ring.value(ring.size() - 1)).isEqualTo(9999);
    assertThat(ring.value(0)).isEqualTo(9999 - 241);
    assertThat(ring.time(0)).isEqualTo(9999 - 241);
  }

  @Test
  void timeThatStandsStillAddsNothingAndTimeThatGoesBackStartsAnew() {
    ring.add(10, 1);
    ring.add(10, 2);
    assertThat(ring.size()).isEqualTo(1);

    ring.add(0, 3);
    assertThat(ring.size()).isEqualTo(1);
    assertThat(ring.value(0)).isEqualTo(3);
  }

  @Test
  void theLargestIsThatOfTheLastMinute() {
    ring.add(0, 500);
    ring.add(30, 80);
    ring.add(59, 20);

    assertThat(ring.largest(60)).isEqualTo(500);
    assertThat(ring.largest(61)).isEqualTo(80);
    assertThat(ring.largest(1000)).isZero();
  }
}
