package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.picture.Picture;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.world.SceneFixture;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/** The window's scene and the software camera show the same things at the same places. */
@NeedsDisplay
class SceneSnapshotSourceDisplayTest {

  /** How far apart a thing may be in the two [pixels]. Documented: asked for. */
  private static final double NEAR = 2;

  private static final SimConfig TWO_DRONES =
      SimConfig.DEFAULT.withRoom(
          Room.DEFAULT,
          List.of(
              new Pose(Vec3.ZERO, Attitude.LEVEL),
              new Pose(new Vec3(1.9, -0.1, 0), Attitude.LEVEL)));

  @RegisterExtension final SceneFixture fixture = new SceneFixture(TWO_DRONES);
  @TempDir private Path folder;

  /** Pixels of a kind: how many, and their middle. */
  private record Spot(int count, double x, double y) {}

  @BeforeEach
  void hangMarkers() throws IOException {
    Poster red = new Poster(Surface.FRONT_WALL, -0.5, 1.1, 0.15, plain("red", 0xff0000));
    // Not as dark as the drone: a pixel at its edge may have its neighbour's colour.
    Poster blue = new Poster(Surface.FRONT_WALL, 0.5, 0.7, 0.15, plain("blue", 0x3c48ff));
    fixture.decorate(decor -> decor.withWalls(Walls.PLAIN).withPosters(List.of(red, blue)));
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
            0,   0,   0
           10,   0,   0
            0,   5,   0
            0,  -5,   0
            0,   0,  20
            0,   0, -35
          -10,   3, -15
            8,  -4,  25
          """)
  void aMarkerIsAtTheSamePlaceInBoth(double yawDeg, double pitchDeg, double rollDeg) {
    fixture.put(
        new Pose(new Vec3(0, 0, 1), attitude(yawDeg, pitchDeg, rollDeg)), FlightPhase.FLYING);
    fixture.pass(0.1);
    int[] photographed = photographed();
    int[] drawn = drawn();

    assertSame(photographed, drawn, SceneSnapshotSourceDisplayTest::isRed);
    assertSame(photographed, drawn, SceneSnapshotSourceDisplayTest::isBlue);
    assertSame(photographed, drawn, SceneSnapshotSourceDisplayTest::isDark); // the other drone
  }

  private static void assertSame(int[] photographed, int[] drawn, IntPredicate kind) {
    Spot inScene = spot(photographed, kind);
    Spot bySoftware = spot(drawn, kind);
    assertThat(inScene.count).isGreaterThan(100);
    assertThat(Math.hypot(inScene.x - bySoftware.x, inScene.y - bySoftware.y))
        .as("%s and %s", inScene, bySoftware)
        .isLessThan(NEAR);
    assertThat(bySoftware.count).isBetween(inScene.count * 8 / 10, inScene.count * 12 / 10);
  }

  private int[] photographed() {
    Picture picture = new Picture(DroneOptics.WIDTH, DroneOptics.HEIGHT);
    int[] argb = new int[DroneOptics.WIDTH * DroneOptics.HEIGHT];
    onFxThread(
        () -> {
          fixture
              .video()
              .photographer()
              .accept(new SnapshotOrder(1, DroneOptics.WIDTH, DroneOptics.HEIGHT, argb));
          return true;
        });
    PictureColors.fill(picture, argb);
    return argb(picture);
  }

  private int[] drawn() {
    Picture picture = new Picture(DroneOptics.WIDTH, DroneOptics.HEIGHT);
    new SoftwareCameras(DroneOptics.DEFAULT)
        .get()
        .film(fixture.snapshot(), new CameraId(1, false), picture);
    return argb(picture);
  }

  private static int[] argb(Picture picture) {
    int[] argb = new int[picture.width() * picture.height()];
    ScreenColors.whole(picture, argb);
    return argb;
  }

  private static Attitude attitude(double yawDeg, double pitchDeg, double rollDeg) {
    double pitch = Math.toRadians(pitchDeg) / 2;
    double roll = Math.toRadians(rollDeg) / 2;
    return Attitude.ofHeading(Math.toRadians(-yawDeg))
        .after(new Attitude(Math.cos(pitch), 0, -Math.sin(pitch), 0))
        .after(new Attitude(Math.cos(roll), Math.sin(roll), 0, 0));
  }

  private static Spot spot(int[] argb, IntPredicate kind) {
    int count = 0;
    long x = 0;
    long y = 0;
    for (int i = 0; i < argb.length; i++) {
      if (kind.test(argb[i])) {
        count++;
        x += i % DroneOptics.WIDTH;
        y += i / DroneOptics.WIDTH;
      }
    }
    return new Spot(count, (double) x / count, (double) y / count);
  }

  private static boolean isRed(int argb) {
    return red(argb) > 150 && green(argb) < 80 && blue(argb) < 80;
  }

  private static boolean isBlue(int argb) {
    return blue(argb) > 150 && green(argb) < 80 && red(argb) < 80;
  }

  /** As only a drone is. */
  private static boolean isDark(int argb) {
    return red(argb) < 70 && green(argb) < 70 && blue(argb) < 70;
  }

  private static int red(int argb) {
    return argb >> 16 & 255;
  }

  private static int green(int argb) {
    return argb >> 8 & 255;
  }

  private static int blue(int argb) {
    return argb & 255;
  }

  private String plain(String name, int rgb) throws IOException {
    BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 64 * 64; i++) {
      image.setRGB(i % 64, i / 64, rgb);
    }
    File file = folder.resolve(name + ".png").toFile();
    ImageIO.write(image, "png", file);
    return file.toString();
  }
}
