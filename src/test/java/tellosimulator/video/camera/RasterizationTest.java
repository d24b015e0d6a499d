package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.video.camera.TestScenes.BLACK;
import static tellosimulator.video.camera.TestScenes.ORIGIN;
import static tellosimulator.video.camera.TestScenes.painted;
import static tellosimulator.video.camera.TestScenes.plain;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.video.camera.TestScenes.Quad;

/** Rasterisation and texture mapping, pixel by pixel. */
@Tag("slow")
class RasterizationTest {

  private static final Vec3 MIDDLE = Vec3.ZERO;

  /** Number of random camera poses; the same in each run. */
  private static final int POSES = 300;

  @Test
  void sharedEdgesHaveNoCracks() {
    SplittableRandom random = new SplittableRandom(1);
    Scene room = Scene.of(TestScenes.room());
    for (int i = 0; i < POSES; i++) {
      PinholeCamera camera =
          new PinholeCamera(
              new Pose(somewhere(random), anyhow(random)), RenderedFrame.INTRINSICS, 0.02);

      assertThat(RenderedFrame.of(camera, room).count(BLACK)).as("%s", camera).isZero();
    }
  }

  @Test
  void sharedEdgesAreNeverDrawnTwice() {
    SplittableRandom random = new SplittableRandom(2);
    Quad floor = new Quad(new Vec3(-30, 30, -0.3), new Vec3(0, -60, 0), new Vec3(60, 0, 0));
    Instance sheer =
        new Instance(
            new Part(TestScenes.mesh(floor), plain(0x80ffffff), Shading.TRANSLUCENT), ORIGIN);
    for (int i = 0; i < POSES; i++) {
      RenderedFrame frame = RenderedFrame.of(anyhow(random), sheer);

      // A pixel that is covered twice would have 191.
      assertThat(Arrays.stream(frame.pixels()).map(pixel -> pixel & 255).distinct())
          .as("look %d", i)
          .isSubsetOf(0, 127, 128);
    }
  }

  @Test
  void textureCoordinatesArePerspectiveCorrectWithinATexel() {
    // Red encodes the position along x, green along y: 0 to 255 on 4 m each.
    int[] argb = new int[256 * 256];
    Arrays.setAll(argb, i -> BLACK | (255 - i / 256) << 16 | (255 - i % 256) << 8);
    Quad quad = new Quad(new Vec3(0, 2, -0.4), new Vec3(0, -4, 0), new Vec3(4, 0, 0));
    Instance floor = painted(new Texture(256, 256, argb), quad);
    CameraIntrinsics intrinsics = new CameraIntrinsics(480, 360, Math.toRadians(70));
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 20; i++) {
      Attitude attitude = leaning(random);
      PinholeCamera camera = new PinholeCamera(new Pose(Vec3.ZERO, attitude), intrinsics, 0.02);
      RenderedFrame frame = RenderedFrame.of(camera, floor);
      int compared = 0;
      for (int pixel = 0; pixel < 480 * 360; pixel += 37) {
        int column = pixel % 480;
        int row = pixel / 480;
        Vec3 ray = ray(camera, column + 0.5, row + 0.5);
        Vec3 hit = ray.times(-0.4 / ray.z());
        if (ray.z() < 0 && hit.x() > 0.1 && hit.x() < 3.9 && Math.abs(hit.y()) < 1.9) {
          int rgb = frame.rgb(column, row);
          // A pixel of the texture, half of which is rounding: 4 m / 256 = 1.6 cm
          Vec3 aside = ray(camera, column + 1.5, row + 1.5);
          Vec3 next = aside.times(-0.4 / aside.z());
          double pixelSize = hit.distanceTo(next);
          assertThat(((rgb >> 16) + 0.5) / 64).isCloseTo(hit.x(), within(0.02 + pixelSize));
          assertThat((((rgb >> 8) & 255) + 0.5) / 64 - 2)
              .isCloseTo(hit.y(), within(0.02 + pixelSize));
          compared++;
        }
      }
      assertThat(compared).isGreaterThan(200);
    }
  }

  @Test
  void aDistantFinePatternIsMipMappedToItsMean() {
    // 256 squares on 4 m, seen from 30 m: five squares fall on a pixel.
    Instance board = painted(TestScenes.checkerboard(256, 512), Quad.ahead(30, MIDDLE, 4));
    PinholeCamera camera = new PinholeCamera(ORIGIN, new CameraIntrinsics(320, 240, 1), 0.1);

    RenderedFrame frame = RenderedFrame.of(camera, board);

    // The mean of the colours of its squares, 0xe0d8c8 and 0x405068.
    int mean = 0x909498;
    assertThat(frame.count(rgb -> rgb != 0)).isGreaterThan(1500);
    assertThat(frame.count(rgb -> rgb != 0 && near(rgb, mean, 3)))
        .isEqualTo(frame.count(rgb -> rgb != 0));
  }

  @Test
  void texturesDoNotFlickerWhenTheCameraMovesAMillimeter() {
    Scene room = Scene.of(TestScenes.room());
    CameraIntrinsics intrinsics = new CameraIntrinsics(480, 360, Math.toRadians(55));
    Attitude attitude = Attitude.ofHeading(0.4);

    RenderedFrame here =
        RenderedFrame.of(
            new PinholeCamera(new Pose(new Vec3(-1, 0, 1), attitude), intrinsics, 0.02), room);
    RenderedFrame there =
        RenderedFrame.of(
            new PinholeCamera(new Pose(new Vec3(-1, 0.001, 1), attitude), intrinsics, 0.02), room);

    // At 3 m, a millimetre is 0.15 pixels: neighbours in the noise differ by up to 200.
    assertThat(meanDifference(here, there)).isPositive().isLessThan(6);
  }

  @Test
  void lightFollowsTheAngleToTheLamp() {
    Quad quad = Quad.ahead(0, MIDDLE, 2);
    Instance facing = lit(plain(0xffc0c0c0), quad);
    RenderedFrame ahead = RenderedFrame.of(facing);
    // Lit from above and the front.
    Attitude tilted = new Attitude(Math.cos(0.4), 0, Math.sin(0.4), 0);
    Instance leaning = new Instance(facing.part(), new Pose(new Vec3(1, 0, 0), tilted), 1, 1);

    // Ambient 0.53; the lamp of 0.55 shines along (0.45, -0.35, -0.82), the sheet faces -x; the
    // other lamp shines from behind.
    assertThat(ahead.rgb(50, 50) & 255).isCloseTo((int) ((0.53 + 0.45 * 0.55) * 0xc0), within(2));
    assertThat(RenderedFrame.of(leaning).rgb(50, 50) & 255)
        .isGreaterThan((ahead.rgb(50, 50) & 255) + 20);
  }

  private static Instance lit(Texture texture, Quad quad) {
    Part part = new Part(TestScenes.mesh(quad), texture, Shading.GLOSSY);
    return new Instance(part, new Pose(new Vec3(1, 0, 0), Attitude.LEVEL));
  }

  private static boolean near(int rgb, int other, int tolerance) {
    for (int shift = 0; shift < 24; shift += 8) {
      if (Math.abs(((rgb >> shift) & 255) - ((other >> shift) & 255)) > tolerance) {
        return false;
      }
    }
    return true;
  }

  private static double meanDifference(RenderedFrame one, RenderedFrame other) {
    double sum = 0;
    for (int i = 0; i < one.pixels().length; i++) {
      sum += Math.abs(((one.pixels()[i] >> 8) & 255) - ((other.pixels()[i] >> 8) & 255));
    }
    return sum / one.pixels().length;
  }

  /** The ray from the camera through an image point, room frame. */
  private static Vec3 ray(PinholeCamera camera, double x, double y) {
    CameraIntrinsics intrinsics = camera.intrinsics();
    Vec3 inCamera =
        new Vec3(
            intrinsics.focalLength(), intrinsics.width() / 2.0 - x, intrinsics.height() / 2.0 - y);
    return camera.pose().attitude().toRoom(inCamera.normalized());
  }

  private static Vec3 somewhere(SplittableRandom random) {
    return new Vec3(
        random.nextDouble(-2.9, 2.9), random.nextDouble(-2.4, 2.4), random.nextDouble(0.05, 2.95));
  }

  private static Attitude anyhow(SplittableRandom random) {
    return new Attitude(
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1))
        .normalized();
  }

  /** A random attitude roughly ahead. */
  private static Attitude leaning(SplittableRandom random) {
    return new Attitude(
            1,
            random.nextDouble(-0.2, 0.2),
            random.nextDouble(0, 0.3),
            random.nextDouble(-0.2, 0.2))
        .normalized();
  }
}
