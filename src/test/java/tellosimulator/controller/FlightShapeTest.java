package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;

/** The course of a flight between command and reply. */
class FlightShapeTest {

  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  @BeforeEach
  void takeOff() {
    drone.ask("command");
    drone.ask("takeoff");
  }

  /** Measured on a real drone over {@code forward 50}: -8 degrees, 3 dm/s, then +4 degrees. */
  @Test
  void forward50PitchesDownThenUpAndPeaksAtThreeDecimetersASecond() {
    List<Motion> way = record("forward 50");

    double lowest = least(way, motion -> motion.attitude().elevation());
    double highest = -least(way, motion -> -motion.attitude().elevation());
    double fastest = -least(way, motion -> -motion.velocity().norm());
    assertThat(Math.toDegrees(lowest)).isCloseTo(-8, within(3.0));
    assertThat(Math.toDegrees(highest)).isCloseTo(4, within(2.0));
    assertThat(Math.round(fastest * 10)).isEqualTo(3);
    int down = indexOf(way, lowest);
    int up = indexOf(way, highest);
    assertThat(down).isLessThan(up);
  }

  @ParameterizedTest
  @CsvSource({"f, 30, 0", "b, -30, 0", "l, 0, 30", "r, 0, -30"})
  void flipTurnsOnceInALoopAndEndsFurtherOn(String direction, double x, double y) {
    List<Motion> way = record("flip " + direction);

    double turned = 0;
    for (Motion motion : way) {
      turned += (direction.matches("[fb]") ? motion.rate().y() : motion.rate().x()) * SimTime.STEP;
    }
    assertThat(Math.abs(Math.toDegrees(turned))).isCloseTo(360, within(1.0));
    assertThat(way).anyMatch(motion -> motion.attitude().up().z() < -0.9);
    double lowest = least(way, motion -> motion.position().z());
    double highest = -least(way, motion -> -motion.position().z());
    assertThat(highest - lowest).isGreaterThan(0.10);
    assertThat(lowest).as("clear of the floor").isGreaterThan(0.10);
    Vec3 moved = way.get(way.size() - 1).position().minus(way.get(0).position()).times(100);
    assertThat(moved.distanceTo(new Vec3(x, y, 0))).isLessThan(10);
  }

  /** The centre of the circle through the start, (25, -25) and (25, -75) is (-25, -50). */
  @Test
  void curveStaysOnItsCircleAndPassesBothPoints() {
    Vec3 start = drone.state().motion().position();
    Vec3 center = start.plus(new Vec3(-0.25, -0.50, 0));
    double radius = Math.sqrt(0.25 * 0.25 + 0.50 * 0.50);

    List<Motion> way = record("curve 25 -25 0 25 -75 0 20");

    assertThat(way)
        .allSatisfy(
            motion ->
                assertThat(motion.position().distanceTo(center)).isCloseTo(radius, within(0.01)));
    assertThat(nearest(way, start.plus(new Vec3(0.25, -0.25, 0)))).isLessThan(0.01);
    assertThat(way.get(way.size() - 1).position().distanceTo(start.plus(new Vec3(0.25, -0.75, 0))))
        .isLessThan(0.01);
    double length = 0;
    for (int i = 1; i < way.size(); i++) {
      length += way.get(i).position().distanceTo(way.get(i - 1).position());
    }
    assertThat(length).as("87.8 cm, not the long way round").isCloseTo(0.878, within(0.03));
  }

  /** A vertical circle that is turned with the drone. */
  @Test
  void curveIsTurnedWithTheDroneAndMayClimb() {
    drone.ask("ccw 90");
    Vec3 start = drone.state().motion().position();

    record("curve 60 0 60 120 0 0 60");

    Vec3 moved = drone.state().motion().position().minus(start);
    assertThat(moved.distanceTo(new Vec3(0, 1.2, 0))).isLessThan(0.01);
  }

  /** A vertical semicircle with a radius of 60 cm would dip by 60 cm, far below the floor. */
  @Test
  void curveThatDipsTooLowStaysAtTheLowestHoverAndStillEndsInPlace() {
    Vec3 start = drone.state().motion().position();

    List<Motion> way = record("curve 60 0 -60 120 0 0 60");

    assertThat(least(way, motion -> motion.position().z())).isCloseTo(0.10, within(0.01));
    Vec3 moved = drone.state().motion().position().minus(start);
    assertThat(moved.distanceTo(new Vec3(1.2, 0, 0))).isLessThan(0.01);
  }

  @Test
  void sticksSinkNoLowerThanTheLowestHover() {
    drone.send("rc 0 0 -50 0");
    drone.advance(3);
    assertThat(drone.state().motion().position().z()).isCloseTo(0.10, within(0.01));

    drone.send("rc 0 0 50 0");
    drone.advance(2);
    drone.send("rc 0 0 0 0");
    drone.advance(3);
    // The speed follows 0.5 - e^(-t / 0.6) m/s, so it climbs from t = 0.42 s on. Until the sticks
    // are centred it gains 0.5 · 2 - 0.6 = 0.4 m, plus 0.09 m that the ground kept it from losing;
    // then it coasts 0.6 s · 0.5 m/s. From the lowest hover, and not from below it: 0.89 m.
    assertThat(drone.state().motion().position().z()).isCloseTo(0.89, within(0.03));
  }

  @Test
  void movesFollowTheNose() {
    drone.ask("cw 90");
    Vec3 start = drone.state().motion().position();

    drone.ask("forward 50");

    Vec3 moved = drone.state().motion().position().minus(start);
    assertThat(moved.distanceTo(new Vec3(0, -0.5, 0))).isLessThan(0.01);
  }

  @Test
  void manyTurnsAreTurnedOneAfterTheOther() {
    List<Motion> way = record("cw 720");

    double turned = way.stream().mapToDouble(motion -> motion.rate().z() * SimTime.STEP).sum();
    assertThat(Math.toDegrees(turned)).isCloseTo(-720, within(1.0));
  }

  private List<Motion> record(String command) {
    List<Motion> way = new ArrayList<>();
    int before = drone.replies().size();
    drone.send(command);
    boolean answered =
        drone.advanceUntil(
            () -> {
              way.add(drone.state().motion());
              return drone.replies().size() > before;
            },
            30);
    assertThat(answered).as("answered").isTrue();
    assertThat(drone.replies().get(before).text()).isEqualTo("ok");
    return way;
  }

  private static double least(List<Motion> way, ToDoubleFunction<Motion> value) {
    return way.stream().mapToDouble(value).min().orElseThrow();
  }

  private static int indexOf(List<Motion> way, double elevation) {
    return way.stream().map(motion -> motion.attitude().elevation()).toList().indexOf(elevation);
  }

  private static double nearest(List<Motion> way, Vec3 point) {
    return least(way, motion -> motion.position().distanceTo(point));
  }
}
