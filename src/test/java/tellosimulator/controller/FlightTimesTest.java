package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;

/** Times from command to {@code ok}, within a quarter of the target times, and final positions. */
class FlightTimesTest {

  private static final Percentage BAND = Percentage.withPercentage(25);

  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  /**
   * The target of {@code curve}: the circle through (0, 0), (25, -25) and (25, -75) has the centre
   * (-25, -50), so its radius is the root of 25² + 50², 55.9 cm. The chords of 35.4 and 50 cm
   * belong to arcs of 2 · 55.9 · asin(35.4 / 111.8) = 36.0 and 2 · 55.9 · asin(50 / 111.8) = 51.8
   * cm: 87.8 cm at 20 cm/s are 4.39 s, plus 1.5 s.
   */
  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # command                   , target, x  , y  , z
          forward 50                  , 2.2   , 50 , 0  , 0
          back 50                     , 2.2   , -50, 0  , 0
          left 50                     , 2.2   , 0  , 50 , 0
          right 50                    , 2.2   , 0  , -50, 0
          forward 100                 , 3.6   , 100, 0  , 0
          up 50                       , 2.2   , 0  , 0  , 50
          cw 90                       , 2.7   , 0  , 0  , 0
          ccw 90                      , 2.7   , 0  , 0  , 0
          flip f                      , 4.0   , 30 , 0  , 0
          flip l                      , 4.0   , 0  , 30 , 0
          go 100 0 0 50               , 4.0   , 100, 0  , 0
          curve 25 -25 0 25 -75 0 20  , 5.89  , 25 , -75, 0
          """)
  void answersInTimeAndInPlace(String command, double target, double x, double y, double z) {
    hoverAt30Cm();
    Vec3 start = position();
    double sent = drone.seconds();

    String reply = drone.ask(command);

    assertThat(reply).isEqualTo("ok");
    assertThat(drone.seconds() - sent).isCloseTo(target, BAND);
    Vec3 moved = position().minus(start).times(100);
    assertThat(moved.distanceTo(new Vec3(x, y, z))).isLessThan(1);
    assertThat(drone.state().motion().velocity().norm()).isLessThan(0.05);
  }

  @Test
  void takeoffRises30CmInThreeSecondsAfterTheReport() {
    drone.ask("command");
    double sent = drone.seconds();

    assertThat(drone.ask("takeoff")).isEqualTo("ok");

    assertThat(drone.seconds() - sent).isCloseTo(3.0, BAND);
    assertThat(position().z()).isCloseTo(0.30, within(0.01));
  }

  @Test
  void takeoffRises80CmAndCreepsUpAsMeasured() {
    SteppedDrone measured = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    measured.ask("command");
    double sent = measured.seconds();
    measured.send("takeoff");

    measured.advance(2.2);
    assertThat(measured.state().motion().position().z()).isBetween(0.70, 0.85);
    measured.advanceUntil(() -> measured.replies().size() > 1, 20);

    assertThat(measured.seconds() - sent).isCloseTo(5.5, BAND);
    assertThat(measured.state().motion().position().z()).isBetween(0.80, 0.94);
  }

  /**
   * A published flight answered moves of 50 cm after 2.24, 1.94, 2.14 and 2.34 s, 2.17 s on
   * average, and {@code land} from 118 cm after 4.23 s; another drone {@code forward 100} after 3.6
   * s. See {@code docs/fidelity.md}.
   */
  @ParameterizedTest
  @CsvSource({
    "forward 50, 2.17",
    "left 50, 2.17",
    "back 50, 2.17",
    "right 50, 2.17",
    "forward 100, 3.6",
    "land, 4.23"
  })
  void answersAsRealDronesDidAsMeasured(String command, double published) {
    SteppedDrone measured = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    measured.ask("command");
    measured.ask("takeoff");
    double sent = measured.seconds();

    assertThat(measured.ask(command)).isEqualTo("ok");

    assertThat(measured.seconds() - sent).isCloseTo(published, Percentage.withPercentage(15));
  }

  @Test
  void landsFrom80CmInThreeSeconds() {
    hoverAt30Cm();
    drone.ask("up 50");
    double sent = drone.seconds();

    assertThat(drone.ask("land")).isEqualTo("ok");

    assertThat(drone.seconds() - sent).isCloseTo(3.0, BAND);
    assertThat(position().z()).isZero();
    assertThat(drone.state().phase().motorsOn()).isFalse();
  }

  @Test
  void turnsLeaveTheDroneWhereItIs() {
    hoverAt30Cm();

    drone.ask("cw 90");

    double yaw = -Math.toDegrees(drone.state().motion().attitude().heading());
    assertThat(yaw).isCloseTo(90, within(0.5));
    assertThat(position().horizontal().norm()).isLessThan(0.01);
  }

  private void hoverAt30Cm() {
    drone.ask("command");
    drone.ask("takeoff");
  }

  private Vec3 position() {
    return drone.state().motion().position();
  }
}
