package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.CapturedLog;
import tellosimulator.time.SimTime;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.world.Decor;
import tellosimulator.world.Walls;

@Timeout(30)
class BackgroundRendererTest {

  private final SimSnapshot snapshot =
      new Simulation(
              SimConfig.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN)),
              drone -> datagram -> {},
              List.of())
          .snapshot();
  private final SceneBuilder scenes = new SceneBuilder();
  private final BackgroundRenderer renderer = new BackgroundRenderer();

  @AfterEach
  void close() {
    renderer.close();
  }

  @Test
  void insideTheRoomAllPixelsAreOpaque() {
    BackgroundRenderer.Rendered rendered = rendered(snapshot, 0).orElseThrow();

    assertThat(rendered.width()).isEqualTo(64);
    assertThat(rendered.height()).isEqualTo(32);
    assertThat(Arrays.stream(rendered.argb()))
        .hasSize(64 * 32)
        .allMatch(argb -> argb >>> 24 == 255);
  }

  @Test
  void besideTheRoomThereIsNothing() {
    BackgroundRenderer.Rendered rendered = rendered(snapshot, -20).orElseThrow();

    // half as wide as the picture at 20 m: 20 m tan(30 degrees) = 11.5 m; the room is 5 m wide
    assertThat(rendered.argb()[16 * 64]).isZero();
    assertThat(rendered.argb()[16 * 64 + 32] >>> 24).isEqualTo(255);
  }

  @Test
  void aViewIsDrawnAgainOnlyIfSomethingInItHasChanged() {
    assertThat(rendered(snapshot, 0)).isPresent();
    SimSnapshot later =
        new SimSnapshot(
            new SimTime(9_000_000_000L),
            snapshot.clock(),
            snapshot.seed(),
            snapshot.arena(),
            snapshot.drones());

    assertThat(rendered(later, 0)).isEmpty();
    assertThat(renderer.settled()).isTrue();
    assertThat(rendered(later, 0.01)).isPresent();
    assertThat(renderer.settled()).isFalse();
  }

  @Test
  void itIsBusyUntilThePictureIsTaken() {
    assertThat(renderer.busy()).isFalse();
    renderer.render(scenes.scene(snapshot), camera(0));
    assertThat(renderer.busy()).isTrue();
    Optional<BackgroundRenderer.Rendered> taken = renderer.take();
    while (taken.isEmpty()) {
      assertThat(renderer.busy()).isTrue();
      taken = renderer.take();
    }

    assertThat(renderer.busy()).isFalse();
  }

  @Test
  void aPictureForWhichMemoryIsNotEnoughCostsThatPictureAlone() throws InterruptedException {
    // 41706 x 51491 = 2^31 - 2: more elements than the JVM allows in an array
    PinholeCamera huge =
        new PinholeCamera(
            new Pose(Vec3.ZERO, Attitude.LEVEL),
            new CameraIntrinsics(41_706, 51_491, Math.PI / 3),
            0.02);
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      assertThat(rendered(snapshot, huge)).isEmpty();

      assertThat(log.next()).startsWith("The room could not be drawn: memory is full");
    }
    assertThat(rendered(snapshot, 0)).isPresent();
  }

  private Optional<BackgroundRenderer.Rendered> rendered(SimSnapshot moment, double x) {
    return rendered(moment, camera(x));
  }

  private Optional<BackgroundRenderer.Rendered> rendered(SimSnapshot moment, PinholeCamera camera) {
    renderer.render(scenes.scene(moment), camera);
    Optional<BackgroundRenderer.Rendered> taken = renderer.take();
    while (renderer.busy()) {
      taken = renderer.take();
    }
    return taken;
  }

  /** A camera in the middle of the room or behind it, looking ahead. */
  private static PinholeCamera camera(double x) {
    return new PinholeCamera(
        new Pose(new Vec3(x, 0, 1), Attitude.LEVEL),
        new CameraIntrinsics(64, 32, Math.PI / 3),
        0.02);
  }
}
