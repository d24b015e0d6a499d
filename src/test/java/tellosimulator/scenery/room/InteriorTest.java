package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.RayTracer;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

class InteriorTest {

  private static final Room ROOM = new Room(4, 6, 3);
  private static final Decor PLAIN = Decor.DEFAULT.withWalls(Walls.PLAIN);
  private static final Decor TEXTURED = Decor.DEFAULT.withWalls(Walls.TEXTURED);
  private static final Vec3 EYE = new Vec3(0.3, 0.2, 1.4);

  private static final Rgb RED = Rgb.of(0xff0000);
  private static final Rgb GREEN = Rgb.of(0x00ff00);
  private static final Rgb BLUE = Rgb.of(0x0000ff);
  private static final Rgb YELLOW = Rgb.of(0xffff00);

  @TempDir private Path folder;
  private final Interior interior = new Interior();

  /** The place of a poster, 0.5 m to the right of a wall's middle and 1.2 m high. */
  private record Place(Vec3 middle, Vec3 right, Vec3 up) {}

  /** The room is 4 m wide (along y, to the left) and 6 m deep (along x). */
  private static Place place(Surface wall) {
    Vec3 x = new Vec3(1, 0, 0);
    Vec3 y = new Vec3(0, 1, 0);
    return switch (wall) {
      case FRONT_WALL -> new Place(new Vec3(3, -0.5, 1.2), y.times(-1), Vec3.UP);
      case BACK_WALL -> new Place(new Vec3(-3, 0.5, 1.2), y, Vec3.UP);
      case LEFT_WALL -> new Place(new Vec3(0.5, 2, 1.2), x, Vec3.UP);
      case RIGHT_WALL -> new Place(new Vec3(-0.5, -2, 1.2), x.times(-1), Vec3.UP);
      case FLOOR -> new Place(new Vec3(1.2, -0.5, 0), y.times(-1), x);
      case CEILING -> new Place(new Vec3(-1.2, -0.5, 3), y.times(-1), x.times(-1));
    };
  }

  @ParameterizedTest
  @EnumSource(Surface.class)
  void aPosterHangsAtItsPlaceUprightAndTheRightWayRound(Surface wall) throws IOException {
    Vec3 middle = place(wall).middle;
    Vec3 right = place(wall).right;
    Vec3 up = place(wall).up;
    // twice as wide as high: 0.8 by 0.4 m
    Poster poster = new Poster(wall, 0.5, 1.2, 0.8, fourColors());
    RayTracer eye = eye(PLAIN.withPosters(List.of(poster)));
    Pose pose = poster.pose(ROOM);
    assertThat(pose.position().distanceTo(middle)).isLessThan(1e-9);
    assertThat(pose.attitude().toRoom(new Vec3(1, 0, 0)).distanceTo(up)).isLessThan(1e-9);
    assertThat(pose.attitude().toRoom(new Vec3(0, -1, 0)).distanceTo(right)).isLessThan(1e-9);

    assertThat(seen(eye, middle.plusScaled(right, -0.38).plusScaled(up, 0.18))).isEqualTo(RED);
    assertThat(seen(eye, middle.plusScaled(right, 0.38).plusScaled(up, 0.18))).isEqualTo(GREEN);
    assertThat(seen(eye, middle.plusScaled(right, -0.38).plusScaled(up, -0.18))).isEqualTo(BLUE);
    assertThat(seen(eye, middle.plusScaled(right, 0.38).plusScaled(up, -0.18))).isEqualTo(YELLOW);
    assertThat(List.of(RED, GREEN, BLUE, YELLOW))
        .doesNotContain(seen(eye, middle.plusScaled(right, 0.42)))
        .doesNotContain(seen(eye, middle.plusScaled(up, -0.22)));
  }

  @Test
  void aPosterEndsWhereItsWallEnds() throws IOException {
    // its left third is beyond the corner: the wall is 4 m wide, so that is at -2 m
    Poster poster = new Poster(Surface.FRONT_WALL, -1.9, 1.2, 0.6, fourColors());
    RayTracer eye = eye(PLAIN.withPosters(List.of(poster)));

    assertThat(seen(eye, new Vec3(3, 1.99, 1.3))).isEqualTo(RED);
    assertThat(seen(eye, new Vec3(3, 1.91, 1.3))).isEqualTo(RED);
    assertThat(seen(eye, new Vec3(3, 1.89, 1.3))).isEqualTo(GREEN);
    assertThat(seen(eye, new Vec3(2.99, 2, 1.3))).isNotEqualTo(RED);
  }

  @Test
  void theLaterPosterIsInFront() throws IOException {
    String picture = fourColors();
    Poster first = new Poster(Surface.FRONT_WALL, 0, 1, 1, picture);
    Poster second = new Poster(Surface.FRONT_WALL, 0.5, 1.2, 1, picture);
    RayTracer eye = eye(PLAIN.withPosters(List.of(first, second)));

    // right of the first one's middle, left of the second one's, in the upper half of both
    assertThat(seen(eye, new Vec3(3, -0.3, 1.23))).isEqualTo(RED);
  }

  @Test
  void aPosterWithoutAFileIsAGrayBoard() {
    Poster poster = new Poster(Surface.FRONT_WALL, 0, 1, 0.5, "no-such.png");

    Rgb color = seen(eye(PLAIN.withPosters(List.of(poster))), new Vec3(3, 0, 1));

    assertThat(color).isEqualTo(Rgb.of(0x9a9a9a));
  }

  @ParameterizedTest
  @EnumSource
  void gridLinesGoThroughTheMiddleOfTheRoom(Walls walls) {
    RayTracer eye = eye(Decor.DEFAULT.withGrid(0.5).withWalls(walls));
    double contrast = walls == Walls.AUTO ? 10 : 20;

    for (double x : new double[] {-1, -0.5, 0, 0.5, 1}) {
      // a line is about 14 mm wide: 7 mm and 1.5 % of the grid
      Vec3 line = new Vec3(x, 0.17, 0);
      double besides = brightness(seen(eye, line.plus(new Vec3(0.02, 0, 0))));
      double before = brightness(seen(eye, line.minus(new Vec3(0.02, 0, 0))));
      assertThat(brightness(seen(eye, line))).isLessThan(Math.max(besides, before) - contrast);
    }
  }

  @Test
  void texturedWallsHaveALineAtEachMeterAndASkirtingBoard() {
    RayTracer eye = eye(TEXTURED);

    for (Surface wall :
        List.of(Surface.FRONT_WALL, Surface.BACK_WALL, Surface.LEFT_WALL, Surface.RIGHT_WALL)) {
      Face face = Face.of(ROOM, wall);
      for (int meter : new int[] {1, 2}) {
        assertThat(brightness(eye, face, meter))
            .as("%s at %d m", wall, meter)
            .isLessThan(brightness(eye, face, meter + 0.03) - 20);
      }
      assertThat(brightness(eye, face, 0.03)).isGreaterThan(200);
    }
  }

  /** Returns the mean brightness of a wall at a height [m]. */
  private static double brightness(RayTracer eye, Face wall, double height) {
    return IntStream.range(-19, 20)
        .mapToDouble(
            i ->
                brightness(
                    seen(eye, wall.origin().plusScaled(wall.right(), 0.1 * i).withZ(height))))
        .average()
        .orElseThrow();
  }

  @Test
  void eachTexturedWallHasAHueOfItsOwn() {
    RayTracer eye = eye(TEXTURED);

    Vec3 front = mean(eye, Surface.FRONT_WALL);
    Vec3 back = mean(eye, Surface.BACK_WALL);
    Vec3 left = mean(eye, Surface.LEFT_WALL);
    Vec3 right = mean(eye, Surface.RIGHT_WALL);
    assertThat(front.y()).as("bricks as green as the accent").isGreaterThan(1.1 * front.x());
    assertThat(back.z()).as("blue tiles").isGreaterThan(1.15 * back.x());
    assertThat(left.x()).as("boards as warm as plaster").isBetween(1.05 * left.z(), 1.3 * left.z());
    assertThat(right.x()).as("ochre paper").isGreaterThan(1.4 * right.z());
  }

  @Test
  void bricksHaveTheHueOfTheAccentAndAreAsBrightAsBefore() {
    Decor rose = new Decor(0.4, Walls.TEXTURED, OptionalInt.of(0xd2b09c), List.of());
    RayTracer usual = eye(TEXTURED);
    RayTracer tinted = eye(rose);

    assertThat(mean(tinted, Surface.FRONT_WALL).x())
        .isGreaterThan(1.15 * mean(tinted, Surface.FRONT_WALL).z());
    for (int i = 0; i < 40; i++) {
      Vec3 place = new Vec3(3, -1.9 + 0.09 * i, 0.4 + 0.05 * i);
      assertThat(brightness(seen(tinted, place)))
          .isCloseTo(brightness(seen(usual, place)), within(1.5));
    }
  }

  @ParameterizedTest
  @EnumSource
  void fromOutsideOneSeesThroughItsWalls(Walls walls) {
    RayTracer eye = eye(Decor.DEFAULT.withWalls(walls));

    Rgb frontThroughTheBack = eye.look(new Vec3(-9, 0.2, 1.4), new Vec3(1, 0, 0));

    assertThat(frontThroughTheBack).isEqualTo(eye.look(EYE, new Vec3(1, 0, 0)));
    assertThat(frontThroughTheBack).isNotEqualTo(Rgb.BLACK);
  }

  @Test
  void itIsDarkerInACornerThanInTheMiddleOfACalmWallAndFloor() {
    RayTracer eye = eye(Decor.DEFAULT);
    double nearTheWall = 0;
    double inTheMiddle = 0;
    for (double y = -1; y < 1; y += 0.02) {
      nearTheWall += brightness(seen(eye, new Vec3(2.95, y, 0)));
      inTheMiddle += brightness(seen(eye, new Vec3(1.95, y, 0)));
    }

    assertThat(nearTheWall).isLessThan(0.9 * inTheMiddle);
    assertThat(meanAt(eye, 1.98)).isLessThan(0.95 * meanAt(eye, 1));
  }

  @Test
  void aCalmRoomHasWindowsAndTheirLightIsOnTheFloorAlongTheKeyLight() {
    RayTracer eye = eye(Decor.DEFAULT);
    // two windows of 1.2 m, 2 m apart; beside the bars
    Vec3 glass = new Vec3(1.3, 2, 1.5);
    Rgb sky = seen(eye, glass);
    Rgb wall = seen(eye, new Vec3(0, 2, 1.5));
    Vec3 lit = glass.plusScaled(Lights.KEY, -glass.z() / Lights.KEY.z());

    assertThat(sky.blue()).as("sky").isGreaterThan(sky.red() + 15);
    assertThat(wall.blue()).as("plaster").isLessThanOrEqualTo(wall.red());
    assertThat(meanAround(eye, lit))
        .isGreaterThan(meanAround(eye, lit.plus(new Vec3(0, -1.2, 0))) + 8);
  }

  /** Returns the mean brightness of a spot of 20 cm on the floor or on a wall across x. */
  private static double meanAround(RayTracer eye, Vec3 middle) {
    double sum = 0;
    int count = 0;
    for (double x = -0.1; x < 0.1; x += 0.01) {
      for (double y = -0.1; y < 0.1; y += 0.01) {
        Vec3 offset = middle.z() == 0 ? new Vec3(x, y, 0) : new Vec3(0, x, y);
        sum += brightness(seen(eye, middle.plus(offset)));
        count++;
      }
    }
    return sum / count;
  }

  @Test
  void aCalmRoomHasADoorAtTheRightOfItsFrontWall() {
    RayTracer eye = eye(Decor.DEFAULT);

    Rgb leaf = seen(eye, new Vec3(3, -1.2, 1.5));
    Rgb wall = seen(eye, new Vec3(3, 1.2, 1.5));
    assertThat(leaf.red()).as("wood").isGreaterThan(leaf.green() + 10);
    assertThat(wall.red()).as("accent").isLessThan(wall.green());
  }

  @ParameterizedTest
  @CsvSource({"6, 6, 2.2", "1, 1, 1"})
  void whatDoesNotFitIntoACalmRoomIsLeftOut(double width, double depth, double height) {
    Room low = new Room(width, depth, height);

    assertThat(RoomWindows.parts(low)).isEmpty();
    assertThat(RoomDoor.parts(low)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"1.2, 6", "6, 2", "20, 20"})
  void theLightOfWindowsEndsWhereTheFloorEnds(double width, double depth) {
    List<Part> parts = RoomWindows.parts(new Room(width, depth, 3));
    assertThat(parts).isNotEmpty();
    for (Part part : parts) {
      for (int i = 0; i < part.mesh().positions(); i++) {
        Vec3 position = part.mesh().position(i);
        assertThat(Math.abs(position.x())).isLessThanOrEqualTo(depth / 2 + 1e-6);
        assertThat(Math.abs(position.y())).isLessThanOrEqualTo(width / 2 + 1e-6);
      }
    }
  }

  /**
   * Returns the mean brightness of the front wall at a distance from its middle [m], from 1.2 to
   * 1.8 m.
   */
  private static double meanAt(RayTracer eye, double along) {
    return IntStream.range(0, 60)
        .mapToDouble(
            i -> brightness(seen(eye, new Vec3(3, along - 0.003 * (i % 6), 1.2 + 0.01 * i))))
        .average()
        .orElseThrow();
  }

  @Test
  void calmWallsAreEvenAndTheFrontOneHasAnAccent() {
    RayTracer eye = eye(Decor.DEFAULT);

    Vec3 front = mean(eye, Surface.FRONT_WALL);
    Vec3 back = mean(eye, Surface.BACK_WALL);
    assertThat(front.y()).as("sage").isGreaterThan(1.03 * front.x());
    assertThat(back.y()).as("white").isGreaterThan(1.15 * front.y());
    Decor terracotta = new Decor(0.4, Walls.AUTO, OptionalInt.of(0xd0a080), List.of());
    Vec3 chosen = mean(eye(terracotta), Surface.FRONT_WALL);
    assertThat(chosen.x()).as("as a scenario says").isGreaterThan(1.3 * chosen.z());
    assertThat(meanAround(eye, new Vec3(-3, 0.31, 1.5)))
        .isCloseTo(meanAround(eye, new Vec3(-3, -0.47, 1.5)), within(6.0));
  }

  @ParameterizedTest
  @EnumSource
  void allDecalsComeAfterWhatTheyAreOn(Walls walls) {
    List<Shading> order =
        interior.instances(ROOM, Decor.DEFAULT.withWalls(walls)).stream()
            .map(instance -> instance.part().material().shading())
            .toList();

    assertThat(order).isSubsetOf(Shading.UNLIT, Shading.PANEL, Shading.DECAL).isSorted();
  }

  @ParameterizedTest
  @EnumSource(names = {"PLAIN", "TEXTURED"})
  void texturesAreKeptWhileOnlyTheSizeChanges(Walls walls) {
    Decor decor = Decor.DEFAULT.withWalls(walls);
    List<Instance> before = interior.instances(ROOM, decor);
    List<Instance> after = interior.instances(new Room(9, 9, 3), decor);

    assertThat(after)
        .extracting(instance -> instance.part().material().texture())
        .isEqualTo(before.stream().map(instance -> instance.part().material().texture()).toList());
  }

  private RayTracer eye(Decor decor) {
    return new RayTracer(Scene.of(interior.instances(ROOM, decor)));
  }

  private static Rgb seen(RayTracer eye, Vec3 place) {
    return eye.look(EYE, place.minus(EYE).normalized());
  }

  private static Vec3 mean(RayTracer eye, Surface wall) {
    Face face = Face.of(ROOM, wall);
    Vec3 sum = Vec3.ZERO;
    int count = 0;
    for (double along = -1.9; along < 1.9; along += 0.13) {
      for (double height = 0.1; height < 2.9; height += 0.13) {
        Rgb color = seen(eye, face.origin().plusScaled(face.right(), along).withZ(height));
        sum = sum.plus(new Vec3(color.red(), color.green(), color.blue()));
        count++;
      }
    }
    return sum.times(1.0 / count);
  }

  private static double brightness(Rgb color) {
    return 0.299 * color.red() + 0.587 * color.green() + 0.114 * color.blue();
  }

  /** Writes an image of 4 by 2 pixels: red, green, and below them blue, yellow. */
  private String fourColors() throws IOException {
    BufferedImage image = new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < 4; x++) {
      image.setRGB(x, 0, (x < 2 ? RED : GREEN).argb());
      image.setRGB(x, 1, (x < 2 ? BLUE : YELLOW).argb());
    }
    Path file = folder.resolve("four.png");
    ImageIO.write(image, "png", file.toFile());
    return file.toString();
  }
}
