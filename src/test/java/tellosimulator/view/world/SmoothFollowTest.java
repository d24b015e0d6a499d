package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;

class SmoothFollowTest {

  private static final double FAR = 100;

  private final SmoothFollow follow = new SmoothFollow(Vec3.ZERO, 0);

  @Test
  void itComesNearerSmoothlyAndArrives() {
    Vec3 target = new Vec3(1, 0, 0);
    follow.advance(target, 0, SmoothFollow.TIME_CONSTANT, FAR);

    // after one time constant 1 - 1/e = 0.632 of the way
    assertThat(follow.point().x()).isCloseTo(0.632, within(0.001));

    follow.advance(target, 0, 5, FAR);
    assertThat(follow.point()).isEqualTo(target);
  }

  @Test
  void theFrameRateMakesNoDifference() {
    SmoothFollow coarse = new SmoothFollow(Vec3.ZERO, 0);
    coarse.advance(new Vec3(1, 2, 3), 1, 0.5, FAR);
    for (int i = 0; i < 50; i++) {
      follow.advance(new Vec3(1, 2, 3), 1, 0.01, FAR);
    }
    assertThat(follow.point().distanceTo(coarse.point())).isLessThan(1e-9);
    assertThat(follow.heading()).isCloseTo(coarse.heading(), within(1e-9));
  }

  @Test
  void aFastDroneNeverLeavesThePicture() {
    follow.advance(new Vec3(8, 0, 0), 0, 0.01, 0.3);

    assertThat(follow.point().x()).isCloseTo(7.7, within(1e-9));
  }

  @Test
  void theHeadingTakesTheShortWay() {
    SmoothFollow nearlyBack = new SmoothFollow(Vec3.ZERO, Math.toRadians(170));
    nearlyBack.advance(Vec3.ZERO, Math.toRadians(-170), 0.1, FAR);

    assertThat(Math.abs(Math.toDegrees(nearlyBack.heading()))).isBetween(170.0, 180.0);
  }
}
