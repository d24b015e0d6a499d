package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/** Mission pads in the pictures of a drone's cameras. */
class PadsInPictureTest {

  private static final Arena EMPTY = Arena.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN));

  private static final Vec3 PLACE = new Vec3(-1, 0.4, 0);

  private static final int WIDTH = 480;

  private static final int HEIGHT = 360;

  @Test
  void fromTheGreatestHeightOfDetectionEachLooksDifferent() {
    List<int[]> all =
        IntStream.rangeClosed(1, MissionPad.LAST_ID)
            .mapToObj(id -> below(MissionPad.onFloor(id, PLACE, 0), 1.2))
            .toList();

    for (int i = 0; i < all.size(); i++) {
      for (int j = 0; j < i; j++) {
        assertThat(difference(all.get(i), all.get(j)))
            .as("pixels in which pads %d and %d differ", i + 1, j + 1)
            .isGreaterThan(150);
      }
    }
  }

  /** In this picture the drone's nose is on the left, and its left side is at the bottom. */
  @ParameterizedTest
  @CsvSource({"0, 1, 0", "90, 0, -1", "180, -1, 0", "270, 0, 1"})
  void theFlameIsWhereTheRocketComesFrom(double rotationDeg, double right, double down) {
    int[] picture = below(MissionPad.onFloor(2, PLACE, Math.toRadians(rotationDeg)), 0.5);

    // The blue part of the rocket is on average 3.5 cm behind the middle of the pad, most of it
    // flame, and the rocket is 4.8 cm right of it: 124 of 512 pixels of 20 cm.
    Vec3 blue = middle(picture, PadsInPictureTest::isBlue);
    assertThat(blue.x() * right + blue.y() * down).as("behind").isCloseTo(0.035, within(0.01));
    assertThat(blue.y() * right - blue.x() * down).as("aside").isCloseTo(-0.048, within(0.004));
  }

  @Test
  void itIsAsLargeAsAPad() {
    int[] picture = below(MissionPad.onFloor(1, PLACE, 0), 0.5);

    long paper = IntStream.range(0, WIDTH).filter(x -> isPaper(at(picture, x, margin()))).count();
    assertThat(paper / pixels(0.5)).isCloseTo(MissionPad.EDGE, within(0.005));
  }

  @Test
  void onAWallItIsSeenAheadWithTheRocketUpwards() {
    MissionPad hanging = new MissionPad(2, Surface.FRONT_WALL, 0.3, 1, 0);
    Pose drone = new Pose(new Vec3(1.7, -0.3, 1.1), Attitude.LEVEL);
    int[] picture = picture(hanging, DroneOptics.DEFAULT.ahead(drone, WIDTH, HEIGHT));

    Vec3 paper = middle(picture, PadsInPictureTest::isPaper);
    Vec3 blue = middle(picture, PadsInPictureTest::isBlue);
    assertThat(blue.x()).as("the rocket is at the right").isGreaterThan(paper.x());
    assertThat(blue.y()).as("the flame is below").isGreaterThan(paper.y());
  }

  @Test
  void onTheLeftWallToo() {
    MissionPad hanging = new MissionPad(2, Surface.LEFT_WALL, -0.4, 1, Math.PI / 2);
    Pose drone = new Pose(new Vec3(-0.4, 1.7, 1.1), Attitude.ofHeading(Math.PI / 2));
    int[] picture = picture(hanging, DroneOptics.DEFAULT.ahead(drone, WIDTH, HEIGHT));

    Vec3 paper = middle(picture, PadsInPictureTest::isPaper);
    Vec3 blue = middle(picture, PadsInPictureTest::isBlue);
    assertThat(blue.y()).as("a quarter turn: the rocket is at the top").isLessThan(paper.y());
    assertThat(blue.x()).as("and flies to the left").isGreaterThan(paper.x());
  }

  /** The row through the white margin at the edge of a pad under a drone at 0.5 m. */
  private static int margin() {
    return (int) (HEIGHT / 2.0 + pixels(0.5) * (MissionPad.EDGE / 2 - 0.002));
  }

  /** Pixels per metre on the floor below the camera of a drone, 8 mm above its feet. */
  private static double pixels(double height) {
    return WIDTH / 2.0 / Math.tan(Math.toRadians(27.5)) / (height + 0.008);
  }

  /** Renders a pad from directly above; the drone that flies there casts no shadow on it. */
  private static int[] below(MissionPad pad, double height) {
    Pose above = new Pose(PLACE.withZ(height), Attitude.LEVEL);
    return picture(pad, DroneOptics.DEFAULT.below(above, WIDTH, HEIGHT));
  }

  private static int[] picture(MissionPad pad, PinholeCamera camera) {
    FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);
    Pose elsewhere = new Pose(new Vec3(-2, -2, 1), Attitude.LEVEL);
    new SoftwareCamera(new RenderCache(ColorSpace.RGB))
        .draw(
            new SceneBuilder()
                .scene(FlyingSnapshots.flying(EMPTY.withPads(List.of(pad)), elsewhere), 1),
            camera,
            frameBuffer);
    int[] argb = new int[WIDTH * HEIGHT];
    frameBuffer.copyTo(argb);
    return argb;
  }

  private static int difference(int[] one, int[] other) {
    return (int)
        IntStream.range(0, one.length)
            .filter(i -> Math.abs((one[i] >> 8 & 255) - (other[i] >> 8 & 255)) > 60)
            .count();
  }

  /**
   * Returns the middle of the matching pixels, to the right and down from the picture's middle [m].
   */
  private static Vec3 middle(int[] picture, IntPredicate kind) {
    Vec3 sum = Vec3.ZERO;
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        if (kind.test(at(picture, x, y))) {
          sum = sum.plus(new Vec3(x + 0.5 - WIDTH / 2.0, y + 0.5 - HEIGHT / 2.0, 0));
          count++;
        }
      }
    }
    assertThat(count).isGreaterThan(20);
    return sum.times(1 / (count * pixels(0.5)));
  }

  private static int at(int[] picture, int x, int y) {
    return picture[y * WIDTH + x] & 0xffffff;
  }

  /** Matches the second colour of pad 2. */
  private static boolean isBlue(int rgb) {
    return (rgb & 255) > (rgb >> 16) + 60;
  }

  /** Matches pixels brighter than floor and walls. */
  private static boolean isPaper(int rgb) {
    return (rgb >> 16) > 240 && (rgb >> 8 & 255) > 240 && (rgb & 255) > 235;
  }
}
