package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;
import static tellosimulator.view.world.SceneFixture.find;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.world.SceneFixture.GoalRegion;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/** Compares the pixels at which the window and the software camera show an object. */
@NeedsDisplay
class SameWorldDisplayTest {

  /** The second drone is orange and stands 0.9 m ahead of the first one, a little to the side. */
  private static final List<Pose> STARTS =
      List.of(
          Formation.row(1, Vec3.ZERO, Room.DEFAULT).get(0),
          new Pose(new Vec3(0.9, -0.1, 0), Attitude.ofHeading(1)));

  @RegisterExtension
  final SceneFixture fixture =
      new SceneFixture(
          SimConfig.DEFAULT
              .withRoom(Room.DEFAULT, STARTS)
              .withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN)));

  @TempDir private Path folder;

  @Test
  void markersAndDronesAreAtTheSamePixelAlsoWhenTheDroneIsTilted() throws IOException {
    List<Poster> posters =
        List.of(
            poster(Surface.FRONT_WALL, new Vec3(0.9, 0.9, 0.3), java.awt.Color.MAGENTA),
            poster(Surface.FRONT_WALL, new Vec3(-0.7, 0.5, 0.2), java.awt.Color.GREEN),
            poster(Surface.FLOOR, new Vec3(-0.3, 1.4, 0.2), java.awt.Color.CYAN));
    fixture.decorate(decor -> decor.withPosters(posters));
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));

    for (double rollDeg : new double[] {0, 17}) {
      double half = Math.toRadians(rollDeg) / 2;
      Attitude rolled = new Attitude(Math.cos(half), Math.sin(half), 0, 0);
      fixture.put(new Pose(new Vec3(-0.6, 0.1, 0.7), rolled), FlightPhase.FLYING);
      Image window = fixture.settledPicture();
      Image drawn = drawn();

      // images of half the camera's width: within one pixel is within two of the camera's
      assertSame(window, drawn, color -> isLike(color, Color.MAGENTA));
      assertSame(window, drawn, color -> isLike(color, Color.LIME));
      assertSame(window, drawn, color -> isLike(color, Color.CYAN));
      assertSame(window, drawn, SameWorldDisplayTest::isOrange);
    }
  }

  @Test
  void obstaclesAndPadsAreAtTheSamePixelAndLookAlike() {
    fixture.furnish(
        arena ->
            arena
                .withObstacles(
                    List.of(
                        obstacle(new Shape.Box(0.4, 0.5, 0.4), new Vec3(0.9, 0.5, 0), 0xff0000),
                        obstacle(new Shape.Cylinder(0.15, 0.8), new Vec3(1.2, -0.6, 0), 0x00ff00),
                        obstacle(new Shape.Ring(0.3, 0.06, 1), new Vec3(1.5, 0, 0), 0x0000ff)))
                .withPads(List.of(MissionPad.onFloor(4, new Vec3(1.3, -0.2, 0), 0.4))));
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    fixture.put(new Pose(new Vec3(-0.6, 0.1, 0.9), Attitude.ofHeading(0.1)), FlightPhase.FLYING);
    Image window = fixture.settledPicture();
    Image drawn = drawn();

    assertSame(window, drawn, SameWorldDisplayTest::isRed);
    assertSame(window, drawn, SameWorldDisplayTest::isGreen);
    assertSame(window, drawn, SameWorldDisplayTest::isBlue);
    assertSamePlace(lowerHalf(window), lowerHalf(drawn), SameWorldDisplayTest::isPaper);
  }

  private static Obstacle obstacle(Shape shape, Vec3 foot, int rgb) {
    return new Obstacle(
        "thing", shape, foot, 0.3, new ObstacleAppearance(rgb, Pattern.PLAIN, Map.of()));
  }

  private static void assertSame(Image window, Image drawn, Predicate<Color> wanted) {
    assertSamePlace(window, drawn, wanted);
    double expected = find(window, wanted).count();
    assertThat((double) find(drawn, wanted).count())
        .isCloseTo(expected, within(0.1 * expected + 10));
  }

  /** The sharpness may differ. */
  private static void assertSamePlace(Image window, Image drawn, Predicate<Color> wanted) {
    GoalRegion expected = find(window, wanted);
    GoalRegion found = find(drawn, wanted);
    assertThat(expected.count()).isGreaterThan(60);
    assertThat(found.x()).isCloseTo(expected.x(), within(1.0));
    assertThat(found.y()).isCloseTo(expected.y(), within(1.0));
  }

  /** Renders the view of the first drone's software camera. */
  private Image drawn() {
    SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
    FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);
    Pose pose = fixture.snapshot().drones().get(0).state().motion().pose();
    camera.draw(
        new SceneBuilder().scene(fixture.snapshot(), 1),
        DroneOptics.DEFAULT.ahead(pose, WIDTH, HEIGHT),
        frameBuffer);
    int[] pixels = new int[WIDTH * HEIGHT];
    frameBuffer.copyTo(pixels);
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] |= 0xff000000;
    }
    WritableImage image = new WritableImage(WIDTH, HEIGHT);
    image
        .getPixelWriter()
        .setPixels(0, 0, WIDTH, HEIGHT, PixelFormat.getIntArgbInstance(), pixels, 0, WIDTH);
    return image;
  }

  /**
   * A square of one colour.
   *
   * @param place along the wall, height, and width [m]
   */
  private Poster poster(Surface wall, Vec3 place, java.awt.Color color) throws IOException {
    BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 64; i++) {
      image.setRGB(i % 8, i / 8, color.getRGB());
    }
    Path file = folder.resolve(String.format(Locale.ROOT, "%x.png", color.getRGB()));
    ImageIO.write(image, "png", file.toFile());
    return new Poster(wall, place.x(), place.y(), place.z(), file.toString());
  }

  private static boolean isLike(Color color, Color wanted) {
    return Math.abs(color.getRed() - wanted.getRed()) < 0.25
        && Math.abs(color.getGreen() - wanted.getGreen()) < 0.25
        && Math.abs(color.getBlue() - wanted.getBlue()) < 0.25;
  }

  /** Crops the image to the half without the window's buttons. */
  private static Image lowerHalf(Image picture) {
    return new WritableImage(picture.getPixelReader(), 0, HEIGHT / 2, WIDTH, HEIGHT / 2);
  }

  /** Matches only the box, in light and in shade. */
  private static boolean isRed(Color color) {
    return color.getRed() > 0.4 && color.getGreen() < 0.1 && color.getBlue() < 0.1;
  }

  /** Matches only the cylinder, in light and in shade. */
  private static boolean isGreen(Color color) {
    return color.getGreen() > 0.4 && color.getRed() < 0.1 && color.getBlue() < 0.1;
  }

  /** Matches only the ring, in light and in shade. */
  private static boolean isBlue(Color color) {
    return color.getBlue() > 0.4 && color.getRed() < 0.1 && color.getGreen() < 0.1;
  }

  /** Matches only the paper of mission pads. */
  private static boolean isPaper(Color color) {
    return color.getBrightness() > 0.88 && color.getSaturation() < 0.1;
  }

  /** Matches only the second drone's cover and its start mark. */
  private static boolean isOrange(Color color) {
    return color.getRed() > 0.5 && color.getRed() > 1.6 * color.getBlue();
  }
}
