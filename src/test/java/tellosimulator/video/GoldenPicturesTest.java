package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.picture.Picture;
import tellosimulator.world.Arena;

/**
 * Compares pictures of the software camera with stored ones. After an intended change, recreate
 * them with {@code mvn test -Dtest=GoldenPicturesTest -Dupdate.golden=true}, and inspect them.
 */
class GoldenPicturesTest {

  private static final Path FOLDER = Path.of("src/test/resources/pictures");

  /**
   * Minimum similarity [dB]. Rounding differences on another processor or JDK result in a far
   * higher value, a shifted or different texture in a far lower one.
   */
  private static final double ALIKE_DB = 45;

  /** Minimum number of corners. OpenCV's ORB finds about as many points in the same pictures. */
  private static final int ENOUGH_CORNERS = 200;

  private enum Golden {
    START_VIEW(false, new Pose(Vec3.ZERO, Attitude.LEVEL)),
    START(false, new Pose(new Vec3(-2, 0, 0), Attitude.LEVEL)),
    CORNER(false, new Pose(new Vec3(0, 0, 1.2), Attitude.ofHeading(0.9))),
    BACK(false, new Pose(new Vec3(1, 0.5, 1.8), Attitude.ofHeading(3.5))),
    LEANING(
        false, new Pose(new Vec3(-1, 1, 0.8), new Attitude(0.96, 0.16, 0.1, -0.2).normalized())),
    NEAR_THE_WALL(false, new Pose(new Vec3(0.2, 1.75, 1), Attitude.ofHeading(1.1))),
    DRONE_AHEAD(
        false,
        new Pose(new Vec3(-1, 0, 1), Attitude.LEVEL),
        new Pose(new Vec3(-0.4, 0.05, 0.9), Attitude.ofHeading(2.5))),
    BELOW(true, new Pose(new Vec3(-2, 0, 1), Attitude.LEVEL)),
    FURNISHED(FurnishedRoom.ARENA, false, new Pose(new Vec3(-1.9, 0, 1.1), Attitude.LEVEL)),
    PADS(FurnishedRoom.ARENA, true, new Pose(new Vec3(-0.65, 0, 0.8), Attitude.LEVEL));

    private final Arena arena;
    private final boolean downward;
    private final Pose[] drones;

    Golden(boolean downward, Pose... drones) {
      this(Arena.DEFAULT, downward, drones);
    }

    Golden(Arena arena, boolean downward, Pose... drones) {
      this.arena = arena;
      this.downward = downward;
      this.drones = drones;
    }

    Path file() {
      return FOLDER.resolve(name().toLowerCase(Locale.ROOT) + ".png");
    }

    Still take() {
      return Still.of(snapshot(), new CameraId(1, downward));
    }

    private SimSnapshot snapshot() {
      return FlyingSnapshots.flying(arena, drones);
    }

    /** Returns the number of corners in a frame of the drone's full size. */
    int corners() {
      Picture picture = downward ? new Picture(320, 240) : new Picture(960, 720);
      new SoftwareCameras(DroneOptics.DEFAULT)
          .get()
          .film(snapshot(), new CameraId(1, downward), picture);
      int[] luma = new int[picture.y().length];
      Arrays.setAll(luma, i -> ((picture.y()[i] & 255) - 16) * 255 / 219);
      return new FastCorners(picture.width(), picture.height(), luma).count();
    }
  }

  @ParameterizedTest
  @EnumSource
  void aPictureIsAsItWas(Golden golden) throws IOException {
    Still still = golden.take();
    if (Boolean.getBoolean("update.golden")) {
      Files.createDirectories(FOLDER);
      still.write(golden.file());
    }

    assertThat(still.likeness(Still.read(golden.file()))).isGreaterThan(ALIKE_DB);
  }

  @ParameterizedTest
  @EnumSource
  void programsFindFeatures(Golden golden) {
    int corners = golden.corners();
    System.out.printf("corners in %s: %d%n", golden, corners);

    assertThat(corners).isGreaterThanOrEqualTo(ENOUGH_CORNERS);
  }
}
