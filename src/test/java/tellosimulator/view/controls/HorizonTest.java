package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.view.controls.AttitudeIndicator.Horizon;

class HorizonTest {

  private static final double RADIUS = 50;

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # pitch, offset, start, extent
          0,   0,   180, 180
          25,  25,  210, 120
          -25, -25, 150, 240
          50,  50,  270, 0
          90,  50,  270, 0
          -90, -50, 90,  360
          """)
  void theMoreTheNosePointsUpTheLessGroundIsSeen(
      double pitch, double offset, double start, double extent) {
    Horizon horizon = Horizon.of(pitch, RADIUS);

    assertThat(horizon.offset()).isEqualTo(offset);
    assertThat(horizon.groundStartDeg()).isCloseTo(start, within(1e-9));
    assertThat(horizon.groundExtentDeg()).isCloseTo(extent, within(1e-9));
  }

  @Test
  void theRungOfThePitchIsInTheMiddle() {
    assertThat(Horizon.of(20, RADIUS).rung(20)).isZero();
    assertThat(Horizon.of(0, RADIUS).rung(10)).isEqualTo(-10); // above, as 50 px are 50 degrees
    assertThat(Horizon.of(0, RADIUS).rung(-10)).isEqualTo(10);
  }
}
