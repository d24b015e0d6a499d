package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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
}
