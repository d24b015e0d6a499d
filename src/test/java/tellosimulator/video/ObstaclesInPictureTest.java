package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Shape;
import tellosimulator.world.Walls;

/** Obstacles in the picture of a drone's camera, pixel by pixel. */
class ObstaclesInPictureTest {

  private static final Arena EMPTY = Arena.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN));

  private static final Pose DRONE = new Pose(new Vec3(-1, 0, 1), Attitude.LEVEL);

  private static final ObstacleAppearance RED = FurnishedRoom.painted(0xff0000, Pattern.PLAIN);

  private static final ObstacleAppearance GREEN = FurnishedRoom.painted(0x00ff00, Pattern.PLAIN);

  @Test
  void aRedBoxAheadIsRedWhereItIsAndNowhereElse() {
    Still still = take(at(new Shape.Box(0.4, 0.4, 0.6), new Vec3(0.7, 0.1, 0.3), RED));
    Still empty = take();

    // The side towards the drone is at x = 0.5, from y = -0.1 to 0.3, from z = 0.3 to 0.9.
    for (double y : new double[] {-0.09, 0.1, 0.29}) {
      for (double z : new double[] {0.31, 0.6, 0.89}) {
        assertThat(rgb(still, new Vec3(0.5, y, z))).matches(ObstaclesInPictureTest::isRed);
      }
    }
    Vec3 below = new Vec3(0.5, 0.1, 0.28); // the floor behind it is visible, in its shadow
    for (int channel : new int[] {0, 8, 16}) {
      int lit = rgb(empty, below) >> channel & 255;
      // no key light, and less light from above
      assertThat((rgb(still, below) >> channel & 255) / (double) lit).isBetween(0.4, 0.7);
    }
    for (Vec3 beside :
        List.of(new Vec3(0.5, -0.11, 0.6), new Vec3(0.5, 0.31, 0.6), new Vec3(0.9, 0.1, 0.93))) {
      assertThat(rgb(still, beside)).isEqualTo(rgb(empty, beside));
    }
  }

  @Test
  void aTopIsBrighterThanTheSidesWhichDifferToo() {
    Obstacle turned =
        at(new Shape.Box(0.5, 0.5, 0.5), new Vec3(0.5, 0, 0), RED)
            .movedTo(new Vec3(0.5, 0, 0), Math.toRadians(45));
    Still still = take(turned);

    int top = rgb(still, new Vec3(0.5, 0, 0.5)) >> 16;
    int left = rgb(still, new Vec3(0.5 - 0.17, 0.17, 0.25)) >> 16;
    int right = rgb(still, new Vec3(0.5 - 0.17, -0.17, 0.25)) >> 16;

    assertThat(top).isGreaterThan(Math.max(left, right) + 20);
    assertThat(Math.abs(left - right)).isGreaterThan(3);
    assertThat(Math.min(left, right)).as("still nearly the colour").isGreaterThan(165);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Math.PI})
  void oneSeesTheWallThroughARingFromBothSides(double heading) {
    Vec3 foot = new Vec3(0.6, 0.05, 0);
    Vec3 middle = foot.withZ(0.75);
    Still still = take(at(new Shape.Ring(0.3, 0.06, 0.75), foot, RED).movedTo(foot, heading));
    Still empty = take();

    for (int degrees = 0; degrees < 360; degrees += 10) {
      double angle = Math.toRadians(degrees);
      Vec3 out = new Vec3(0, Math.cos(angle), Math.sin(angle));
      Vec3 within = middle.plusScaled(out, 0.27);
      assertThat(rgb(still, within)).isEqualTo(rgb(empty, within));
      assertThat(rgb(still, middle.plusScaled(out, 0.33)))
          .as("at %d degrees", degrees)
          .matches(ObstaclesInPictureTest::isRed);
    }
    assertThat(rgb(still, foot.withZ(0.3)))
        .as("the post")
        .isNotEqualTo(rgb(empty, foot.withZ(0.3)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Math.PI})
  void oneSeesTheWallThroughAFrameFromBothSides(double heading) {
    Vec3 foot = new Vec3(0.6, 0, 0);
    Still still =
        take(at(new Shape.Frame(0.6, 0.5, 0.06, 0.9), foot, GREEN).movedTo(foot, heading));
    Still empty = take();

    Vec3 middle = foot.withZ(0.9);
    for (Vec3 within : List.of(new Vec3(0, 0.25, 0.2), new Vec3(0, -0.25, -0.2), Vec3.ZERO)) {
      assertThat(rgb(still, middle.plus(within))).isEqualTo(rgb(empty, middle.plus(within)));
    }
    for (Vec3 beam :
        List.of(
            new Vec3(0, 0.33, 0),
            new Vec3(0, -0.33, 0),
            new Vec3(0, 0, 0.28),
            new Vec3(0, 0, -0.28))) {
      assertThat(rgb(still, middle.plus(beam))).matches(ObstaclesInPictureTest::isGreen);
    }
  }

  @Test
  void theNearerOneHidesTheFartherOne() {
    Obstacle near = at(new Shape.Box(0.2, 0.3, 0.6), new Vec3(0.5, 0, 0.4), RED);
    Obstacle far = at(new Shape.Cylinder(0.3, 1.5), new Vec3(1.5, 0, 0), GREEN);
    Vec3 onNear = new Vec3(0.4, 0, 0.7);

    assertThat(rgb(take(near, far), onNear)).matches(ObstaclesInPictureTest::isRed);
    assertThat(rgb(take(far, near), onNear)).matches(ObstaclesInPictureTest::isRed);
    assertThat(rgb(take(far), onNear)).matches(ObstaclesInPictureTest::isGreen);
  }

  @Test
  void anObstacleHidesADrone() {
    Pose other = new Pose(new Vec3(0.8, 0, 0.8), Attitude.LEVEL);
    Obstacle wall = at(new Shape.Box(0.05, 1, 1), new Vec3(0.3, 0, 0.3), RED);
    Still hidden =
        Still.ahead(FlyingSnapshots.flying(EMPTY.withObstacles(List.of(wall)), DRONE, other));
    Still alone = take(wall);

    assertThat(rgb(hidden, other.position())).isEqualTo(rgb(alone, other.position()));
  }

  private static Obstacle at(Shape shape, Vec3 foot, ObstacleAppearance appearance) {
    return new Obstacle("thing", shape, foot, 0, appearance);
  }

  private static Still take(Obstacle... obstacles) {
    return Still.ahead(FlyingSnapshots.flying(EMPTY.withObstacles(List.of(obstacles)), DRONE));
  }

  /** Returns the colour in the direction of a place in the room. */
  private static int rgb(Still still, Vec3 place) {
    PinholeCamera eye = DroneOptics.DEFAULT.ahead(DRONE, Still.WIDTH, Still.HEIGHT);
    Vec3 seen = eye.pose().attitude().toBody(place.minus(eye.pose().position()));
    CameraIntrinsics intrinsics = eye.intrinsics();
    double x = intrinsics.width() / 2.0 - intrinsics.focalLength() * seen.y() / seen.x();
    double y = intrinsics.height() / 2.0 - intrinsics.focalLength() * seen.z() / seen.x();
    return still.rgb((int) x, (int) y);
  }

  private static boolean isRed(int rgb) {
    return (rgb >> 16) > 140 && (rgb >> 8 & 255) < 90 && (rgb & 255) < 90;
  }

  private static boolean isGreen(int rgb) {
    return (rgb >> 16) < 90 && (rgb >> 8 & 255) > 140 && (rgb & 255) < 90;
  }
}
