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

/** What the software camera sees is the same only while its pictures are. */
class SightTest {

  private static final CameraId AHEAD = new CameraId(1, false);
  private static final Pose HERE = at(0, 0);
  private static final Pose THERE = at(2, 0);

  private final FrameSource camera = new SoftwareCameras(DroneOptics.DEFAULT).get();
  private final Object sight = sight(Moments.flying(HERE, THERE));

  @Test
  void atTheSamePlaceItIsTheSame() {
    assertThat(sight(Moments.flying(HERE, THERE))).isEqualTo(sight);
  }

  @Test
  void whereTheDroneStandsElsewhereItIsAnother() {
    assertThat(sight(Moments.flying(at(0, 0.001), THERE))).isNotEqualTo(sight);
  }

  @Test
  void whereTheDroneHasTurnedItIsAnother() {
    Pose turned = new Pose(HERE.position(), Attitude.ofHeading(0.001));

    assertThat(sight(Moments.flying(turned, THERE))).isNotEqualTo(sight);
  }

  @Test
  void whereAnotherDroneStandsElsewhereItIsAnother() {
    assertThat(sight(Moments.flying(HERE, at(2, 0.001)))).isNotEqualTo(sight);
  }

  @Test
  void inARoomThatLooksDifferentItIsAnother() {
    assertThat(sight(Moments.flying(Decor.DEFAULT.withGrid(1), HERE, THERE))).isNotEqualTo(sight);
  }

  @Test
  void downwardItIsAnother() {
    SimSnapshot moment = Moments.flying(HERE, THERE);

    assertThat(camera.sight(moment, new CameraId(1, true))).isNotEqualTo(sight);
  }

  private Object sight(SimSnapshot moment) {
    return camera.sight(moment, AHEAD);
  }

  private static Pose at(double x, double y) {
    return new Pose(new Vec3(x, y, 1), Attitude.LEVEL);
  }
}
