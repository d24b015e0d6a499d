package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.video.camera.TestScenes.RED;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.video.camera.TestScenes.Quad;

class DroneOpticsTest {

  private static final DroneOptics OPTICS = DroneOptics.DEFAULT;

  @Test
  void theForwardCameraOfALevelDroneLooksFifteenDegreesDown() {
    Attitude attitude = Attitude.ofHeading(Math.toRadians(90));

    Pose camera = OPTICS.nose(new Pose(new Vec3(1, 1, 1), attitude));

    assertThat(Math.toDegrees(camera.attitude().elevation())).isCloseTo(-15, within(1e-9));
    assertThat(Math.toDegrees(camera.attitude().heading())).isCloseTo(90, within(1e-9));
    // 3.5 cm ahead, which is along y
    assertThat(camera.position().distanceTo(new Vec3(1, 1.035, 1.0185))).isLessThan(1e-9);
  }

  @ParameterizedTest
  @CsvSource({"55, 15", "55, 90", "55, -90", "150, 15", "150, 60", "10, 0"})
  void theNearPlaneDoesNotClipTheFloorBelowAStandingDrone(double fieldOfViewDeg, double tiltDeg) {
    DroneOptics optics =
        new DroneOptics(Math.toRadians(fieldOfViewDeg), Math.toRadians(tiltDeg), 640);
    Quad floor = new Quad(new Vec3(-50, 50, 0), new Vec3(0, -100, 0), new Vec3(100, 0, 0));

    RenderedFrame seen =
        RenderedFrame.of(
            optics.ahead(TestScenes.ORIGIN, 96, 72),
            TestScenes.painted(TestScenes.plain(RED), floor));

    // The same camera with a near plane close to zero.
    PinholeCamera camera = optics.ahead(TestScenes.ORIGIN, 96, 72);
    PinholeCamera all = new PinholeCamera(camera.pose(), camera.intrinsics(), 1e-4);
    assertThat(seen.count(RED))
        .isEqualTo(
            RenderedFrame.of(all, TestScenes.painted(TestScenes.plain(RED), floor)).count(RED));
  }

  @Test
  void theForwardCameraPitchesAndRollsWithTheDrone() {
    double half = Math.toRadians(10) / 2;
    Attitude noseDown = new Attitude(Math.cos(half), 0, Math.sin(half), 0);
    Attitude rightDown = new Attitude(Math.cos(half), Math.sin(half), 0, 0);

    Attitude pitched = OPTICS.nose(new Pose(Vec3.ZERO, noseDown)).attitude();
    Attitude rolled = OPTICS.nose(new Pose(Vec3.ZERO, rightDown)).attitude();

    assertThat(Math.toDegrees(pitched.elevation())).isCloseTo(-25, within(1e-9));
    assertThat(rolled.toRoom(new Vec3(0, 1, 0)).z()).as("left edge of the picture").isPositive();
  }
}
