package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.video.camera.Sketches.BLACK;
import static tellosimulator.video.camera.Sketches.ORIGIN;
import static tellosimulator.video.camera.Sketches.painted;
import static tellosimulator.video.camera.Sketches.plain;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.Texture;
import tellosimulator.video.camera.Sketches.Sheet;

/** How surfaces are filled, pixel for pixel. */
class SurfaceTest {

  private static final Vec3 MIDDLE = Vec3.ZERO;

  /** So many ways to look at a thing; the same with each run. */
  private static final int LOOKS = 300;

  @Test
  void fromWhereverOneLooksARoomHasNoCracks() {
    SplittableRandom random = new SplittableRandom(1);
    Scene room = new Scene(Sketches.room());
    for (int i = 0; i < LOOKS; i++) {
      Viewpoint viewpoint =
          new Viewpoint(new Pose(somewhere(random), anyhow(random)), Screen.LENS, 0.02);

      assertThat(Screen.of(viewpoint, room).count(BLACK)).as("%s", viewpoint).isZero();
    }
  }

  @Test
  void theTrianglesOfASheetNeverShareAPixel() {
    SplittableRandom random = new SplittableRandom(2);
    Sheet floor = new Sheet(new Vec3(-30, 30, -0.3), new Vec3(0, -60, 0), new Vec3(60, 0, 0));
    Placed sheer =
        new Placed(new Part(Sketches.mesh(floor), plain(0x80ffffff), Finish.SHEER), ORIGIN);
    for (int i = 0; i < LOOKS; i++) {
      Screen screen = Screen.of(anyhow(random), sheer);

      // A pixel that is covered twice would have 191.
      assertThat(Arrays.stream(screen.pixels()).map(pixel -> pixel & 255).distinct())
          .as("look %d", i)
          .isSubsetOf(0, 127, 128);
    }
  }

  @Test
  void perspectiveIsRightWithinAPixel() {
    // Red tells how far along x a place is, green how far along y: 0 to 255 on 4 m each.
    int[] argb = new int[256 * 256];
    Arrays.setAll(argb, i -> BLACK | (255 - i / 256) << 16 | (255 - i % 256) << 8);
    Sheet sheet = new Sheet(new Vec3(0, 2, -0.4), new Vec3(0, -4, 0), new Vec3(4, 0, 0));
    Placed floor = painted(new Texture(256, 256, argb), sheet);
    Lens lens = new Lens(480, 360, Math.toRadians(70));
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 20; i++) {
      Attitude attitude = leaning(random);
      Viewpoint viewpoint = new Viewpoint(new Pose(Vec3.ZERO, attitude), lens, 0.02);
      Screen screen = Screen.of(viewpoint, floor);
      int compared = 0;
      for (int pixel = 0; pixel < 480 * 360; pixel += 37) {
        int column = pixel % 480;
        int row = pixel / 480;
        Vec3 ray = ray(viewpoint, column + 0.5, row + 0.5);
        Vec3 hit = ray.times(-0.4 / ray.z());
        if (ray.z() < 0 && hit.x() > 0.1 && hit.x() < 3.9 && Math.abs(hit.y()) < 1.9) {
          int rgb = screen.rgb(column, row);
          // A pixel of the texture, half of which is rounding: 4 m / 256 = 1.6 cm
          Vec3 aside = ray(viewpoint, column + 1.5, row + 1.5);
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
  void farAwayAFinePatternIsItsMean() {
    // 256 squares on 4 m, seen from 30 m: five squares fall on a pixel.
    Placed board = painted(Sketches.chessboard(256, 512), Sheet.ahead(30, MIDDLE, 4));
    Viewpoint viewpoint = new Viewpoint(ORIGIN, new Lens(320, 240, 1), 0.1);

    Screen screen = Screen.of(viewpoint, board);

    // The mean of the colours of its squares, 0xe0d8c8 and 0x405068.
    int mean = 0x909498;
    assertThat(screen.count(rgb -> rgb != 0)).isGreaterThan(1500);
    assertThat(screen.count(rgb -> rgb != 0 && near(rgb, mean, 3)))
        .isEqualTo(screen.count(rgb -> rgb != 0));
  }

  @Test
  void aMillimetreChangesHardlyAnything() {
    Scene room = new Scene(Sketches.room());
    Lens lens = new Lens(480, 360, Math.toRadians(55));
    Attitude attitude = Attitude.ofHeading(0.4);

    Screen here =
        Screen.of(new Viewpoint(new Pose(new Vec3(-1, 0, 1), attitude), lens, 0.02), room);
    Screen there =
        Screen.of(new Viewpoint(new Pose(new Vec3(-1, 0.001, 1), attitude), lens, 0.02), room);

    // At 3 m, a millimetre is 0.15 pixels: neighbours in the noise differ by up to 200.
    assertThat(meanDifference(here, there)).isPositive().isLessThan(6);
  }

  @Test
  void whatFacesTheLampMoreIsBrighter() {
    Sheet sheet = Sheet.ahead(0, MIDDLE, 2);
    Placed facing = lit(plain(0xffc0c0c0), sheet);
    Screen ahead = Screen.of(facing);
    // Shone on from above and the front.
    Attitude tilted = new Attitude(Math.cos(0.4), 0, Math.sin(0.4), 0);
    Placed leaning = new Placed(facing.part(), new Pose(new Vec3(1, 0, 0), tilted), 1, 1);

    // Ambient 0.53; the lamp of 0.55 shines along (0.45, -0.35, -0.82), the sheet faces -x; the
    // other lamp shines from behind.
    assertThat(ahead.rgb(50, 50) & 255).isCloseTo((int) ((0.53 + 0.45 * 0.55) * 0xc0), within(2));
    assertThat(Screen.of(leaning).rgb(50, 50) & 255).isGreaterThan((ahead.rgb(50, 50) & 255) + 20);
  }

  private static Placed lit(Texture texture, Sheet sheet) {
    Part part = new Part(Sketches.mesh(sheet), texture, Finish.LIT);
    return new Placed(part, new Pose(new Vec3(1, 0, 0), Attitude.LEVEL));
  }

  private static boolean near(int rgb, int other, int tolerance) {
    for (int shift = 0; shift < 24; shift += 8) {
      if (Math.abs(((rgb >> shift) & 255) - ((other >> shift) & 255)) > tolerance) {
        return false;
      }
    }
    return true;
  }

  private static double meanDifference(Screen one, Screen other) {
    double sum = 0;
    for (int i = 0; i < one.pixels().length; i++) {
      sum += Math.abs(((one.pixels()[i] >> 8) & 255) - ((other.pixels()[i] >> 8) & 255));
    }
    return sum / one.pixels().length;
  }

  /** From the eye through a place of the picture, room frame. */
  private static Vec3 ray(Viewpoint viewpoint, double x, double y) {
    Lens lens = viewpoint.lens();
    Vec3 inCamera = new Vec3(lens.focalLength(), lens.width() / 2.0 - x, lens.height() / 2.0 - y);
    return viewpoint.pose().attitude().toRoom(inCamera.normalized());
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

  /** Ahead, more or less. */
  private static Attitude leaning(SplittableRandom random) {
    return new Attitude(
            1,
            random.nextDouble(-0.2, 0.2),
            random.nextDouble(0, 0.3),
            random.nextDouble(-0.2, 0.2))
        .normalized();
  }
}
