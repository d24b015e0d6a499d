package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;

/** In the default room: 5 m by 5 m, 3 m high. */
class FootprintTest {

  /** A board of 0.2 m by 1 m: turned by 90°, half of its width extends along x. */
  @ParameterizedTest
  @CsvSource({
    "2.4,    0,   0, true",
    "2.4005, 0,   0, true",
    "2.402,  0,   0, false",
    "2.4,    0,  90, false",
    "2,      0,  90, true",
    "0,      2.1, 0, false",
    "0,      0,   0, true",
  })
  void aBoardIsBetweenTheWallsAsItIsTurned(double x, double y, double turnedDeg, boolean inside) {
    assertThat(inside(new Shape.Box(0.2, 1, 1), new Vec3(x, y, 0), turnedDeg)).isEqualTo(inside);
  }

  @ParameterizedTest
  @CsvSource({"0", "45", "90"})
  void aCylinderNeedsTheSameRoomHoweverItIsTurned(double turnedDeg) {
    Shape pole = new Shape.Cylinder(0.5, 1);
    assertThat(inside(pole, new Vec3(2, -2, 0), turnedDeg)).isTrue();
    assertThat(inside(pole, new Vec3(2.01, 0, 0), turnedDeg)).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"2, true", "2.0005, true", "2.002, false"})
  void nothingReachesAboveTheCeiling(double base, boolean inside) {
    assertThat(inside(new Shape.Box(1, 1, 1), new Vec3(0, 0, base), 0)).isEqualTo(inside);
  }

  private static boolean inside(Shape shape, Vec3 foot, double turnedDeg) {
    double heading = StrictMath.toRadians(turnedDeg);
    return Footprint.inside(
        new Obstacle("thing", shape, foot, heading, ObstacleAppearance.DEFAULT), Room.DEFAULT);
  }
}
