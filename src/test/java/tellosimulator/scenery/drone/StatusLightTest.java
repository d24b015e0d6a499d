package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.model.FlightPhase;

class StatusLightTest {

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          OFF,       100, false, DARK
          OFF,       3,   true,  DARK
          GROUNDED,  100, false, WAITING
          GROUNDED,  100, true,  READY
          FLYING,    11,  true,  READY
          FLYING,    10,  true,  LOW_BATTERY
          GROUNDED,  10,  false, LOW_BATTERY
          LANDING,   5,   true,  CRITICAL_BATTERY
          CRASHED,   100, true,  FAILED
          """)
  void itShowsWhatTheDroneDoes(
      FlightPhase phase, double battery, boolean commanded, StatusLight expected) {
    assertThat(StatusLight.of(phase, battery, commanded)).isEqualTo(expected);
  }

  @Test
  void readyBlinksTwiceInEachPeriod() {
    assertThat(flashes(StatusLight.READY, 1.4)).isEqualTo(2);
  }

  @Test
  void aCriticalBatteryBlinksFasterThanALowOne() {
    assertThat(flashes(StatusLight.CRITICAL_BATTERY, 6))
        .isGreaterThan(3 * flashes(StatusLight.LOW_BATTERY, 6));
  }

  @Test
  void afterACrashItIsSteadyAndWithoutPowerDark() {
    assertThat(litParts(StatusLight.FAILED)).isEqualTo(1000);
    assertThat(litParts(StatusLight.DARK)).isZero();
  }

  private static long flashes(StatusLight light, double seconds) {
    int parts = (int) Math.round(seconds * 1000);
    return IntStream.range(0, parts)
        .filter(i -> light.lit((i + 0.5) / 1000) && !light.lit((i - 0.5) / 1000))
        .count();
  }

  private static long litParts(StatusLight light) {
    return IntStream.range(0, 1000).filter(i -> light.lit(i / 1000.0)).count();
  }
}
