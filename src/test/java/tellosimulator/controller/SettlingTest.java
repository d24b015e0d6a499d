package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.SimTime;

class SettlingTest {

  private static final Setpoint TARGET =
      new Setpoint.Track(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, new Setpoint.Heading(0, 0));

  private final Settling settling = new Settling(0.3);

  private void observe(double off, boolean pushed, double seconds) {
    Motion motion = at(off);
    for (int i = 0; i < seconds / SimTime.STEP; i++) {
      settling.observe(TARGET, motion, false, pushed);
    }
  }

  private static Motion at(double off) {
    return Motion.restingAt(new Pose(new Vec3(off, 0, 0), Attitude.LEVEL));
  }

  @ParameterizedTest
  @CsvSource({"0.005, true", "0.011, false", "0.1, false"})
  void inStillAirACentimeterCountsHoweverLongItTakes(double off, boolean settled) {
    observe(off, false, 7);

    assertThat(settling.settled()).isEqualTo(settled);
  }

  @ParameterizedTest
  @CsvSource({"0.1, 1.9, false", "0.1, 2.4, true", "0.2, 7, false"})
  void inWindItIsEnoughAfterTwoSecondsToBeAboutThere(double off, double seconds, boolean settled) {
    observe(off, true, seconds);

    assertThat(settling.settled()).isEqualTo(settled);
  }

  @Test
  void withoutTimeItIsEnoughToBeThere() {
    Settling atOnce = new Settling(0);
    assertThat(atOnce.settled()).as("before it was looked at").isFalse();

    atOnce.observe(TARGET, at(0.1), false, false);
    assertThat(atOnce.settled()).isFalse();

    atOnce.observe(TARGET, at(0), false, false);
    assertThat(atOnce.settled()).isTrue();
  }

  @Test
  void itGivesUpAfterEightSeconds() {
    observe(0.1, false, 7.9);
    assertThat(settling.givenUp()).isFalse();

    observe(0.1, false, 0.2);
    assertThat(settling.givenUp()).isTrue();
  }
}
