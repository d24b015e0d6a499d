package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

class MissionPadTest {

  private static final Room ROOM = new Room(4, 6, 3);
  private static final Vec3 ROCKET = new Vec3(1, 0, 0);

  @Test
  void onTheFloorTheRocketPointsAlongTheHeading() {
    Pose pose = MissionPad.onFloor(3, new Vec3(1, -0.5, 0), Math.PI / 2).pose(ROOM);

    assertThat(pose.position()).isEqualTo(new Vec3(1, -0.5, 0));
    assertNear(pose.attitude().toRoom(ROCKET), new Vec3(0, 1, 0));
    assertNear(pose.attitude().toRoom(Vec3.UP), Vec3.UP);
  }

  /** The room is 6 m deep along x and 4 m wide along y; right is as seen from inside. */
  @ParameterizedTest
  @CsvSource({
    "FRONT_WALL, 3, -0.5, -1, 0",
    "BACK_WALL, -3, 0.5, 1, 0",
    "LEFT_WALL, 0.5, 2, 0, -1",
    "RIGHT_WALL, -0.5, -2, 0, 1"
  })
  void onAWallTheRocketPointsUpAndThePadFacesTheRoom(
      Surface wall, double x, double y, double outX, double outY) {
    Pose pose = new MissionPad(1, wall, 0.5, 1.2, 0).pose(ROOM);

    assertNear(pose.position(), new Vec3(x, y, 1.2));
    assertNear(pose.attitude().toRoom(ROCKET), Vec3.UP);
    assertNear(pose.attitude().toRoom(Vec3.UP), new Vec3(outX, outY, 0));
  }

  @Test
  void onAWallARotationIsCounterClockwiseAsOneSeesIt() {
    Pose pose = new MissionPad(1, Surface.FRONT_WALL, 0, 1, Math.PI / 2).pose(ROOM);

    assertNear(pose.attitude().toRoom(ROCKET), new Vec3(0, 1, 0));
  }

  @Test
  void thereAreEightAndNoneOnTheCeiling() {
    assertThatThrownBy(() -> MissionPad.onFloor(9, Vec3.ZERO, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("pad is 9");
    assertThatThrownBy(() -> new MissionPad(1, Surface.CEILING, 0, 0, 0))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private static void assertNear(Vec3 actual, Vec3 expected) {
    assertThat(actual.distanceTo(expected)).as("%s is not %s", actual, expected).isLessThan(1e-9);
  }
}
