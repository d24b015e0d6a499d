package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/** The positions and colours of a room's content in a drone's pictures. */
class ViewFromTheDroneTest {

  private static final Decor PLAIN = Decor.DEFAULT.withWalls(Walls.PLAIN);

  /** The middle of the room, 1.2 m high; the nose points to the front wall. */
  private static final Vec3 MIDDLE = new Vec3(0, 0, 1.2);

  /** Focal length [pixels]: half a picture is tan(55 degrees / 2) = 0.5206 wide at 1 m. */
  private static final double FOCAL_LENGTH = Still.WIDTH / 2 / Math.tan(Math.toRadians(27.5));

  /**
   * Distance from the left or right edge of a column that contains no number of the floor [pixels].
   */
  private static final int EDGE = 6;

  @TempDir private Path folder;

  @Test
  void aRedWallIsRed() throws IOException {
    Still still = Still.ahead(withRed(at(MIDDLE, 0), new Poster(Surface.FRONT_WALL, 0, 1, 6, "")));

    int rgb = still.rgb(Still.WIDTH / 2, Still.HEIGHT / 2);

    assertThat(rgb >> 16).isGreaterThan(240);
    assertThat(rgb >> 8 & 255).isLessThan(15);
    assertThat(rgb & 255).isLessThan(15);
  }

  @Test
  void whatHangsOnTheLeftIsOnTheLeft() throws IOException {
    double left = redColumn(at(MIDDLE, 0), -0.6);
    double right = redColumn(at(MIDDLE, 0), 0.6);

    assertThat(left).isBetween(0.0, Still.WIDTH * 0.4);
    assertThat(left + right).isCloseTo(Still.WIDTH, within(1.0));
  }

  @Test
  void turningRightMovesWhatIsAheadToTheLeft() throws IOException {
    double before = redColumn(at(MIDDLE, 0), 0);
    double after = redColumn(at(MIDDLE, -10), 0);

    // The tilt of the camera makes the distance along its axis cos 15 degrees of that to the wall,
    // plus an effect of the poster being level with it: tan 10 / cos 15 = 0.1825.
    assertThat(before).isCloseTo(Still.WIDTH / 2.0, within(1.0));
    assertThat(after - before).isCloseTo(-0.1825 * FOCAL_LENGTH, within(3.0));
  }

  @Test
  void comingNearerMakesItLarger() throws IOException {
    int far = redPixels(at(MIDDLE, 0));
    int near = redPixels(at(MIDDLE.plus(new Vec3(1, 0, 0)), 0));

    assertThat(near).isGreaterThan(far * 3 / 2);
  }

  @Test
  void theHorizonTiltsWithRollAndRisesWithANoseThatSinks() {
    int[] level = floorAtLeftMiddleAndRight(Attitude.LEVEL);
    int[] rolled = floorAtLeftMiddleAndRight(turned(1, 10));
    int[] pitched = floorAtLeftMiddleAndRight(turned(2, 5));

    assertThat(level[0]).isCloseTo(level[2], within(1));
    // Right side down: level lines rise to the right by tan 10 degrees.
    assertThat(rolled[0] - rolled[2])
        .isCloseTo((int) ((Still.WIDTH - 2 * EDGE) * 0.176), within(6));
    // Nose down by 5 degrees of 9.7 f: near the axis that is tan 5 degrees times f = 40 pixels.
    assertThat(level[1] - pitched[1]).isBetween(38, 44);
  }

  @Test
  void theCameraBelowSeesWhatLiesOnTheFloorWithTheNoseToTheLeft() throws IOException {
    // Bright on the floor, 30 cm ahead of the drone's middle.
    Poster ahead = new Poster(Surface.FLOOR, 0, 0.3, 0.2, file(Color.WHITE));
    Decor decor = PLAIN.withPosters(List.of(ahead));

    Still still = Still.of(FlyingSnapshots.flying(decor, at(MIDDLE, 0)), new CameraId(1, true));

    assertThat(still.column(rgb -> rgb == 0xffffff)).isBetween(0.0, Still.WIDTH * 0.45);
  }

  private double redColumn(Pose drone, double along) throws IOException {
    Poster poster = new Poster(Surface.FRONT_WALL, along, 1.2, 0.3, "");
    return Still.ahead(withRed(drone, poster)).column(ViewFromTheDroneTest::isRed);
  }

  private int redPixels(Pose drone) throws IOException {
    Poster poster = new Poster(Surface.FRONT_WALL, 0, 1.2, 0.3, "");
    Still still = Still.ahead(withRed(drone, poster));
    int count = 0;
    for (int x = 0; x < Still.WIDTH; x++) {
      for (int y = 0; y < Still.HEIGHT; y++) {
        count += isRed(still.rgb(x, y)) ? 1 : 0;
      }
    }
    return count;
  }

  /** Returns the rows at which the floor begins below the front wall. */
  private static int[] floorAtLeftMiddleAndRight(Attitude attitude) {
    Still still = Still.ahead(FlyingSnapshots.flying(PLAIN, new Pose(MIDDLE, attitude)));
    int floor = still.rgb(Still.WIDTH / 2, Still.HEIGHT - 20);
    return new int[] {
      still.firstRow(EDGE, rgb -> isLike(rgb, floor)),
      still.firstRow(Still.WIDTH / 2, rgb -> isLike(rgb, floor)),
      still.firstRow(Still.WIDTH - EDGE, rgb -> isLike(rgb, floor))
    };
  }

  private SimSnapshot withRed(Pose drone, Poster where) throws IOException {
    Poster poster =
        new Poster(where.surface(), where.along(), where.height(), where.width(), file(Color.RED));
    return FlyingSnapshots.flying(Decor.DEFAULT.withPosters(List.of(poster)), drone);
  }

  private String file(Color color) throws IOException {
    BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setColor(color);
    graphics.fillRect(0, 0, 8, 8);
    graphics.dispose();
    Path file = folder.resolve("poster.png");
    ImageIO.write(image, "png", file.toFile());
    return file.toString();
  }

  private static Pose at(Vec3 place, double headingDeg) {
    return new Pose(place, Attitude.ofHeading(Math.toRadians(headingDeg)));
  }

  /** Returns an attitude turned around the body's x (1) or y axis (2). */
  private static Attitude turned(int axis, double angleDeg) {
    double half = Math.toRadians(angleDeg) / 2;
    double sine = Math.sin(half);
    return new Attitude(Math.cos(half), axis == 1 ? sine : 0, axis == 2 ? sine : 0, 0);
  }

  private static boolean isRed(int rgb) {
    return rgb >> 16 > 200 && (rgb >> 8 & 255) < 60 && (rgb & 255) < 60;
  }

  private static boolean isLike(int rgb, int other) {
    int difference = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      difference += Math.abs((rgb >> shift & 255) - (other >> shift & 255));
    }
    return difference < 12;
  }
}
