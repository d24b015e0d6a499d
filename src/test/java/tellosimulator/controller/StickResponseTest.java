package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.model.Motion;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;

/**
 * The response of a drone to the sticks in behaviour {@code measured}: TelloPy 0.7.0,
 * docs/sensor_time.md, measured in September 2026 with one drone.
 */
class StickResponseTest {

  /** Duration of a recorded response [s]. */
  private static final double LOOK = 1;

  /** Mean time of a reading on its way to the program [s]. */
  private static final double LINK = 0.025;

  /**
   * The published times, 91 to 108 ms to half of the rate, include the way of the reading to the
   * program; {@code conformance/response_lag.py} measures them with it.
   */
  @ParameterizedTest
  @ValueSource(strings = {"rc 0 0 0 100", "rc 0 0 0 -60"})
  void theTurningRateFollowsAsMeasured(String rc) {
    List<Double> rates = response(rc, motion -> Math.abs(motion.rate().z()));

    assertThat(reached(rates, 0.1)).as("10 %").isBetween(0.020, 0.052);
    assertThat(reached(rates, 0.5)).as("50 %").isBetween(0.091 - LINK, 0.108 - LINK);
  }

  @ParameterizedTest
  @ValueSource(strings = {"rc 0 60 0 0", "rc 0 -100 0 0"})
  void thePitchFollowsAsMeasured(String rc) {
    List<Double> angles = response(rc, motion -> Math.abs(motion.attitude().elevation()));

    assertThat(reached(angles, 0.1)).as("10 %").isBetween(0.155, 0.175);
    assertThat(reached(angles, 0.5)).as("50 %").isBetween(0.2489, 0.2661);
  }

  @Test
  void theRollFollowsAsMeasured() {
    List<Double> angles = response("rc 60 0 0 0", motion -> Math.abs(motion.attitude().bank()));

    assertThat(reached(angles, 0.1)).as("10 %").isBetween(0.155, 0.175);
    assertThat(reached(angles, 0.5)).as("50 %").isBetween(0.2489, 0.2661);
  }

  /** Returns the values of each step after the sticks were moved. */
  private static List<Double> response(String rc, ToDoubleFunction<Motion> value) {
    SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    drone.ask("command");
    drone.ask("takeoff");
    drone.advance(1);
    drone.send(rc);
    List<Double> values = new ArrayList<>();
    for (double time = 0; time < LOOK; time += SimTime.STEP) {
      drone.advance(SimTime.STEP);
      values.add(value.applyAsDouble(drone.state().motion()));
    }
    return values;
  }

  /** Returns the time at which a part of the maximum was reached [s]. */
  private static double reached(List<Double> values, double part) {
    double wanted = part * Collections.max(values);
    int step = 0;
    while (values.get(step) < wanted) {
      step++;
    }
    return (step + 1) * SimTime.STEP;
  }
}
