package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.model.FlightPhase;

class PropellerSpinTest {

  @ParameterizedTest
  @EnumSource(
      value = FlightPhase.class,
      names = {"OFF", "GROUNDED", "FALLING", "CRASHED"})
  void withMotorsOffTheyStandStill(FlightPhase phase) {
    assertThat(PropellerSpin.of(phase, 7)).isEqualTo(new PropellerSpin(false, 0));
  }

  @Test
  void idlingOneSeesBladesAndFlyingADisc() {
    assertThat(PropellerSpin.of(FlightPhase.IDLING, 3).blurred()).isFalse();
    assertThat(PropellerSpin.of(FlightPhase.FLYING, 3).blurred()).isTrue();
  }

  @Test
  void theyTurnFromFrameToFrame() {
    double before = PropellerSpin.of(FlightPhase.IDLING, 1).angle();
    double after = PropellerSpin.of(FlightPhase.IDLING, 1 + 1 / 30.0).angle();

    // 26 rad/s for a thirtieth of a second; from a quarter turn on blades seem to turn backwards
    double turn = (after - before + 2 * Math.PI) % (2 * Math.PI);
    assertThat(turn).isCloseTo(26 / 30.0, within(1e-9)).isLessThan(Math.PI / 2);
  }
}
