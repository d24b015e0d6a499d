package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.world.Decor;

/** Views of the software camera are equal only if their pictures are. */
class CameraViewTest {

  private static final CameraId AHEAD = new CameraId(1, false);
  private static final Pose HERE = at(0, 0);
  private static final Pose THERE = at(2, 0);

  private final FrameSource camera = new SoftwareCameras(DroneOptics.DEFAULT).get();
  private final Object view = view(FlyingSnapshots.flying(HERE, THERE));

  @Test
  void atTheSamePlaceItIsTheSame() {
    assertThat(view(FlyingSnapshots.flying(HERE, THERE))).isEqualTo(view);
  }

  @Test
  void whereTheDroneStandsElsewhereItIsAnother() {
    assertThat(view(FlyingSnapshots.flying(at(0, 0.001), THERE))).isNotEqualTo(view);
  }

  @Test
  void whereTheDroneHasTurnedItIsAnother() {
    Pose turned = new Pose(HERE.position(), Attitude.ofHeading(0.001));

    assertThat(view(FlyingSnapshots.flying(turned, THERE))).isNotEqualTo(view);
  }

  @Test
  void whereAnotherDroneStandsElsewhereItIsAnother() {
    assertThat(view(FlyingSnapshots.flying(HERE, at(2, 0.001)))).isNotEqualTo(view);
  }

  @Test
  void inARoomThatLooksDifferentItIsAnother() {
    assertThat(view(FlyingSnapshots.flying(Decor.DEFAULT.withGrid(1), HERE, THERE)))
        .isNotEqualTo(view);
  }

  @Test
  void downwardItIsAnother() {
    SimSnapshot moment = FlyingSnapshots.flying(HERE, THERE);

    assertThat(camera.view(moment, new CameraId(1, true))).isNotEqualTo(view);
  }

  private Object view(SimSnapshot moment) {
    return camera.view(moment, AHEAD);
  }

  private static Pose at(double x, double y) {
    return new Pose(new Vec3(x, y, 1), Attitude.LEVEL);
  }
}
