package tellosimulator.scenery.orbit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

class OrbitTest {

  private static final Vec3 DRONE = new Vec3(1, 2, 1.5);
  private static final double FAR = 20;

  private final Orbit orbit = new Orbit(0, Math.toRadians(30), 2, Vec3.ZERO);

  @Test
  void itLooksAtThePivotFromBehindAndAbove() {
    Pose pose = orbit.pose(DRONE);

    // 2 m away, 30 degrees up: 2 cos 30° = 1.732 m behind, 2 sin 30° = 1 m above
    assertThat(pose.position().distanceTo(new Vec3(1 - 1.7320508, 2, 2.5))).isLessThan(1e-6);
    Vec3 ahead = pose.attitude().toRoom(new Vec3(2, 0, 0));
    assertThat(pose.position().plus(ahead).distanceTo(DRONE)).isLessThan(1e-9);
  }

  @ParameterizedTest
  @CsvSource({"10", "-10"})
  void itNeverTurnsOver(double elevationChange) {
    Pose pose = orbit.turned(0, elevationChange).pose(DRONE);

    assertThat(pose.attitude().up().z()).as("up in the picture").isPositive();
  }

  @ParameterizedTest
  @CsvSource({"0, 0.3", "0.02, 2", "0.02, 15", "1.5, 15"})
  void itIsNeverBelowTheFloor(double droneHeight, double distance) {
    for (double elevation = -2; elevation <= 2; elevation += 0.1) {
      Orbit low = new Orbit(0.4, elevation, distance, Vec3.ZERO);

      double height = low.pose(DRONE.withZ(droneHeight)).position().z();

      assertThat(height).isGreaterThanOrEqualTo(Orbit.ABOVE_FLOOR - 1e-9);
    }
  }

  @Test
  void itIsNeverBelowTheFloorWhenShiftedDown() {
    Pose pose = orbit.shifted(0, -50, FAR).turned(0, -3).pose(DRONE);

    assertThat(pose.position().z()).isGreaterThanOrEqualTo(Orbit.ABOVE_FLOOR - 1e-9);
  }

  @Test
  void itComesNeitherTooNearNorGoesTooFar() {
    assertThat(orbit.zoomed(1e-6, FAR).distance()).isEqualTo(Orbit.NEAREST);
    assertThat(orbit.zoomed(1e6, FAR).distance()).isEqualTo(FAR);
  }

  @Test
  void aShiftMovesThePivotInThePlaneOfThePicture() {
    Orbit shifted = orbit.shifted(0.5, 0.2, FAR);

    Vec3 moved = shifted.pose(DRONE).position().minus(orbit.pose(DRONE).position());
    Vec3 inPicture = orbit.pose(DRONE).attitude().toBody(moved);
    assertThat(inPicture.distanceTo(new Vec3(0, -0.5, 0.2))).isLessThan(1e-9);
    assertThat(orbit.shifted(1000, 0, FAR).shift().norm()).isCloseTo(FAR, within(1e-9));
  }

  @Test
  void aPivotAsideInThePictureStaysThereWhenItTurnsAndZooms() {
    Orbit aside = orbit.seenAt(new Orbit.Offset(0.2, -0.1));

    for (Orbit each : List.of(aside, aside.turned(1, 0.2), aside.zoomed(3, FAR))) {
      Pose pose = each.pose(DRONE);
      Vec3 seen = pose.attitude().toBody(DRONE.minus(pose.position()));
      assertThat(seen.x()).isCloseTo(each.distance(), within(1e-9));
      assertThat(seen.y() / seen.x()).isCloseTo(0.2, within(1e-9));
      assertThat(seen.z() / seen.x()).isCloseTo(-0.1, within(1e-9));
    }
  }

  @Test
  void withAPivotAsideItIsNeverBelowTheFloor() {
    for (double up : new double[] {-0.3, 0.3}) {
      Orbit low = new Orbit(0, -1, 3, Vec3.ZERO, new Orbit.Offset(0, up));

      assertThat(low.pose(DRONE).position().z()).isCloseTo(Orbit.ABOVE_FLOOR, within(1e-9));
    }
  }

  @Test
  void anOrbitIsTheOneOfACameraElsewhere() {
    Vec3 place = new Vec3(-4, 1, 3);

    Orbit other = orbit.seenFrom(place, DRONE);

    assertThat(other.pose(Vec3.ZERO).position().distanceTo(place)).isLessThan(1e-9);
    assertThat(other.pose(Vec3.ZERO).attitude()).isEqualTo(orbit.pose(Vec3.ZERO).attitude());
  }

  @Test
  void onItsWayToAnotherItTurnsTheShorterWayRound() {
    Orbit from = new Orbit(Math.toRadians(170), 0.2, 1, Vec3.ZERO);
    Orbit to = new Orbit(Math.toRadians(-170), 0.4, 4, new Vec3(2, 0, 0));

    Orbit half = from.towards(to, 0.5);

    assertThat(half.heading()).isCloseTo(Math.PI, within(1e-9));
    assertThat(half.elevation()).isCloseTo(0.3, within(1e-9));
    assertThat(half.distance()).as("twice as far, and twice again").isCloseTo(2, within(1e-9));
    assertThat(half.shift().distanceTo(new Vec3(1, 0, 0))).isLessThan(1e-9);
    assertThat(
            from.towards(to, 1)
                .pose(Vec3.ZERO)
                .position()
                .distanceTo(to.pose(Vec3.ZERO).position()))
        .isLessThan(1e-9);
  }
}
