package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.concurrent.Verdict;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Stage;
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
class PainterTest {

  private final SimSnapshot snapshot =
      new Simulation(
              SimConfig.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN)),
              drone -> (peer, text) -> {},
              report -> {},
              List.of())
          .snapshot();
  private final Painter painter = new Painter(new Stage());

  @AfterEach
  void close() {
    painter.close();
  }

  @Test
  void insideTheRoomAllPixelsAreOpaque() {
    Painter.Painted painted = painted(view(snapshot, 0)).orElseThrow();

    assertThat(painted.width()).isEqualTo(64);
    assertThat(painted.height()).isEqualTo(32);
    assertThat(Arrays.stream(painted.argb())).hasSize(64 * 32).allMatch(argb -> argb >>> 24 == 255);
  }

  @Test
  void besideTheRoomThereIsNothing() {
    Painter.Painted painted = painted(view(snapshot, -20)).orElseThrow();

    // half as wide as the picture at 20 m: 20 m tan(30 degrees) = 11.5 m; the room is 5 m wide
    assertThat(painted.argb()[16 * 64]).isZero();
    assertThat(painted.argb()[16 * 64 + 32] >>> 24).isEqualTo(255);
  }

  @Test
  void aViewIsDrawnAgainOnlyIfSomethingInItHasChanged() {
    assertThat(painted(view(snapshot, 0))).isPresent();
    SimSnapshot later =
        new SimSnapshot(
            new SimTime(9_000_000_000L), snapshot.clock(), snapshot.arena(), snapshot.drones());

    assertThat(painted(view(later, 0))).isEmpty();
    assertThat(painter.settled()).isTrue();
    assertThat(painted(view(later, 0.01))).isPresent();
    assertThat(painter.settled()).isFalse();
  }

  @Test
  void itIsBusyUntilThePictureIsTaken() {
    assertThat(painter.busy()).isFalse();
    painter.paint(view(snapshot, 0));
    assertThat(painter.busy()).isTrue();
    Optional<Painter.Painted> taken = painter.take();
    while (taken.isEmpty()) {
      assertThat(painter.busy()).isTrue();
      taken = painter.take();
    }

    assertThat(painter.busy()).isFalse();
  }

  @Test
  void aPictureForWhichMemoryIsNotEnoughCostsThatPictureAlone() throws InterruptedException {
    // 41706 x 51491 = 2^31 - 2: more elements than any array of the Java machine may have
    PinholeCamera huge =
        new PinholeCamera(
            new Pose(Vec3.ZERO, Attitude.LEVEL),
            new CameraIntrinsics(41_706, 51_491, Math.PI / 3),
            0.02);
    try (CapturedLog log = CapturedLog.of(Verdict.class)) {
      assertThat(painted(new Painter.View(snapshot, OptionalInt.empty(), huge, List.of())))
          .isEmpty();

      assertThat(log.next()).startsWith("The room could not be drawn: memory is full");
    }
    assertThat(painted(view(snapshot, 0))).isPresent();
  }

  private Optional<Painter.Painted> painted(Painter.View view) {
    painter.paint(view);
    Optional<Painter.Painted> taken = painter.take();
    while (painter.busy()) {
      taken = painter.take();
    }
    return taken;
  }

  /** Ahead, from the middle of the room or from behind it. */
  private static Painter.View view(SimSnapshot snapshot, double x) {
    PinholeCamera viewpoint =
        new PinholeCamera(
            new Pose(new Vec3(x, 0, 1), Attitude.LEVEL),
            new CameraIntrinsics(64, 32, Math.PI / 3),
            0.02);
    return new Painter.View(snapshot, OptionalInt.empty(), viewpoint, List.of());
  }
}
