package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;

class PropellerSpinTest {

  private static final double FRAME = 1.0 / 20;

  private static final Motion HOVER = Motion.restingAt(new Pose(Vec3.ZERO, Attitude.LEVEL));

  private final PropellerSpin spin = new PropellerSpin();

  @ParameterizedTest
  @EnumSource(
      value = FlightPhase.class,
      names = {"OFF", "GROUNDED", "FALLING", "CRASHED"})
  void withMotorsOffTheyStandStill(FlightPhase phase) {
    assertThat(PropellerSpin.wanted(phase, HOVER)).isZero();
    assertThat(spin.advance(0, FRAME)).isFalse();
  }

  @Test
  void idlingOneSeesBladesAndFlyingADisc() {
    run(PropellerSpin.wanted(FlightPhase.IDLING, HOVER), 3);
    assertThat(spin.blurred()).isFalse();

    run(PropellerSpin.wanted(FlightPhase.FLYING, HOVER), 3);
    assertThat(spin.blurred()).isTrue();
    assertThat(spin.speed()).isCloseTo(1, within(0.01));
  }

  @Test
  void moreThrustTurnsThemFaster() {
    Vec3 twice = HOVER.acceleration().times(2);
    Motion climbing = new Motion(Vec3.ZERO, Vec3.ZERO, twice, Attitude.LEVEL, Vec3.ZERO);

    assertThat(PropellerSpin.wanted(FlightPhase.FLYING, climbing))
        .isCloseTo(Math.sqrt(2), within(1e-9));
  }

  @Test
  void theyRunDownAndComeToRest() {
    run(1, 2);
    run(0, 0.2);
    assertThat(spin.speed()).isBetween(0.3, 0.9);

    run(0, 5);
    assertThat(spin.speed()).isZero();
    assertThat(spin.advance(0, FRAME)).isFalse();
  }

  @Test
  void theyNeverTurnSoFarInAPictureThatTheySeemToTurnBackwards() {
    run(1.4, 3);
    double before = spin.angle();

    spin.advance(1.4, 10);

    double turn = (spin.angle() - before + 2 * Math.PI) % (2 * Math.PI);
    assertThat(turn).isPositive().isLessThan(Math.PI / 2);
  }

  private void run(double wanted, double seconds) {
    for (double t = 0; t < seconds; t += FRAME) {
      spin.advance(wanted, FRAME);
    }
  }
}
