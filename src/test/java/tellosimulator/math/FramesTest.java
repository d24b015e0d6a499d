package tellosimulator.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FramesTest {

  @ParameterizedTest
  @CsvSource({"0, 0", "90, -90", "-45, 45", "720, -720"})
  void yawIsClockwiseAndHeadingCounterClockwise(double yaw, double headingDegrees) {
    assertThat(Math.toDegrees(Frames.headingOfYaw(yaw))).isCloseTo(headingDegrees, within(1e-9));
    assertThat(Frames.yawOfHeading(Frames.headingOfYaw(yaw))).isCloseTo(yaw, within(1e-9));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 20, -500, 35.234234})
  void centimetersComeBack(double centimeters) {
    assertThat(Frames.meters(centimeters)).isEqualTo(centimeters / 100);
    assertThat(Frames.centimeters(Frames.meters(centimeters)))
        .isCloseTo(centimeters, within(1e-12));
  }

  @Test
  void theWireHasYToTheRightAndZDown() {
    Vec3 vector = new Vec3(1, 2, 3);

    assertThat(Frames.flipped(vector)).isEqualTo(new Vec3(1, -2, -3));
    assertThat(Frames.flipped(Frames.flipped(vector))).isEqualTo(vector);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "190, -170", "-190, 170", "360, 0", "3610, 10", "-730, -10", "90, 90"})
  void anglesAreWrappedToHalfATurn(double degrees, double wrapped) {
    assertThat(Math.toDegrees(Frames.wrapped(Math.toRadians(degrees))))
        .isCloseTo(wrapped, within(1e-9));
  }

  @Test
  void onTheScreenForwardLeadsInLeftIsLeftAndUpIsUp() {
    assertThat(Frames.toScreen(new Vec3(1, 2, 3))).isEqualTo(new Vec3(-2, -3, 1));
    assertThat(Frames.fromScreen(Frames.toScreen(new Vec3(1, 2, 3)))).isEqualTo(new Vec3(1, 2, 3));
  }
}
