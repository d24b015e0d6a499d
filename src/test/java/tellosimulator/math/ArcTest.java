package tellosimulator.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ArcTest {

  private static final double TINY = 1e-12;

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # via,        end,         centre,       radius,            degrees
          # Radius 56 and 69 cm of curves that real drones flew (DJITelloPy 10, TelloEduSwarmSearch):
          25 -25 0,     25 -75 0,    -25 -50 0,    55.90169943749474, 90
          # Half circles: the centre lies between start and end.
          50 50 0,      100 0 0,     50 0 0,       50,                180
          50 -50 0,     100 0 0,     50 0 0,       50,                180
          50 0 50,      100 0 0,     50 0 0,       50,                180
          0 50 50,      0 100 0,     0 50 0,       50,                180
          # Three quarters, the long way round through (200, 0).
          200 0 0,      100 -100 0,  100 0 0,      100,               270
          # A quarter, the short way to the same end.
          29.28932188134524 -70.71067811865476 0, 100 -100 0, 100 0 0, 100, 90
          """)
  void passesThroughBothPoints(
      String via, String end, String center, double radius, double degrees) {
    Arc arc = Arc.through(point(via), point(end)).orElseThrow();

    assertThat(arc.radius()).isCloseTo(radius, within(1e-9));
    assertThat(arc.center().distanceTo(point(center))).isLessThan(1e-9);
    assertThat(Math.toDegrees(arc.angle())).isCloseTo(degrees, within(1e-9));
    assertThat(arc.length()).isCloseTo(radius * Math.toRadians(degrees), within(1e-9));
    assertThat(arc.point(0).norm()).isLessThan(1e-9);
    assertThat(arc.point(arc.angle()).distanceTo(point(end))).isLessThan(1e-9);
    assertThat(nearestDistance(arc, point(via))).isLessThan(radius * 1e-3);
  }

  @Test
  void theSecondCurveOfARealDroneHasARadiusOf69Centimeters() {
    Arc arc = Arc.through(new Vec3(-55, -20, 0), new Vec3(-75, -75, 0)).orElseThrow();

    assertThat(arc.radius()).isCloseTo(69, within(0.5));
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          50 0 0,   100 0 0
          100 0 0,  50 0 0
          50 50 50, -50 -50 -50
          50 0 0,   50 0 0
          0 0 0,    100 0 0
          50 0 0,   0 0 0
          """)
  void pointsOnOneLineHaveNoCircle(String via, String end) {
    assertThat(Arc.through(point(via), point(end))).isEmpty();
  }

  @Test
  void motionIsTangentialAndTheCenterInwards() {
    Arc arc = Arc.through(new Vec3(0.5, 0.5, 0.2), new Vec3(1, -0.3, 0.4)).orElseThrow();

    for (int i = 0; i <= 10; i++) {
      double swept = arc.angle() * i / 10;
      Vec3 chord = arc.point(swept + 1e-6).minus(arc.point(swept - 1e-6)).normalized();
      assertThat(arc.direction(swept).norm()).isCloseTo(1, within(TINY));
      assertThat(arc.inward(swept).norm()).isCloseTo(1, within(TINY));
      assertThat(arc.direction(swept).dot(arc.inward(swept))).isCloseTo(0, within(TINY));
      assertThat(arc.direction(swept).distanceTo(chord)).isLessThan(1e-8);
      Vec3 center = arc.point(swept).plusScaled(arc.inward(swept), arc.radius());
      assertThat(center.distanceTo(arc.center())).isLessThan(TINY);
    }
  }

  private static double nearestDistance(Arc arc, Vec3 point) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= 10_000; i++) {
      nearest = Math.min(nearest, arc.point(arc.angle() * i / 10_000).distanceTo(point));
    }
    return nearest;
  }

  private static Vec3 point(String words) {
    String[] numbers = words.split(" ", -1);
    return new Vec3(
        Double.parseDouble(numbers[0]),
        Double.parseDouble(numbers[1]),
        Double.parseDouble(numbers[2]));
  }
}
