package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.video.camera.Sketches.BLACK;
import static tellosimulator.video.camera.Sketches.BLUE;
import static tellosimulator.video.camera.Sketches.GREEN;
import static tellosimulator.video.camera.Sketches.RED;
import static tellosimulator.video.camera.Sketches.WHITE;
import static tellosimulator.video.camera.Sketches.painted;
import static tellosimulator.video.camera.Sketches.plain;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Texture;
import tellosimulator.video.camera.Sketches.Sheet;

class SoftwareCameraTest {

  private static final Vec3 MIDDLE = Vec3.ZERO;

  /** A square of 20 cm at a distance of 1 m is 10 pixels wide: 50 pixels a metre. */
  private static final double SIZE = 0.2;

  @Test
  void whatIsOnTheLeftAppearsOnTheLeft() {
    Screen screen =
        Screen.of(
            painted(plain(RED), Sheet.ahead(1, new Vec3(0, 0.5, 0), SIZE)),
            painted(plain(GREEN), Sheet.ahead(1, new Vec3(0, 0, 0.5), SIZE)));

    assertThat(screen.column(RED)).isCloseTo(50 - 0.5 * 50, within(0.01));
    assertThat(screen.row(RED)).isCloseTo(50, within(0.01));
    assertThat(screen.column(GREEN)).isCloseTo(50, within(0.01));
    assertThat(screen.row(GREEN)).as("up").isCloseTo(50 - 0.5 * 50, within(0.01));
    assertThat(screen.count(RED)).isEqualTo(10 * 10);
  }

  @Test
  void turningRightMovesWhatIsSeenToTheLeft() {
    Placed ahead = painted(plain(RED), Sheet.ahead(1, MIDDLE, SIZE));

    Screen before = Screen.of(ahead);
    Screen after = Screen.of(Attitude.ofHeading(Math.toRadians(-10)), ahead);

    // 50 pixels times tan 10 degrees = 8.8
    assertThat(after.column(RED) - before.column(RED)).isCloseTo(-8.8, within(0.3));
  }

  @Test
  void whatIsNearerHidesWhatIsBehindInWhateverOrderTheyCome() {
    Placed near = painted(plain(RED), Sheet.ahead(1, MIDDLE, 0.4));
    Placed far = painted(plain(GREEN), Sheet.ahead(2, MIDDLE, 4));

    for (Screen screen : new Screen[] {Screen.of(near, far), Screen.of(far, near)}) {
      assertThat(screen.count(RED)).isEqualTo(20 * 20);
      assertThat(screen.count(GREEN)).isEqualTo(100 * 100 - 20 * 20);
    }
  }

  @Test
  void sheetsThatCrossHideEachOtherWhereTheyAreBehind() {
    // From 1.5 m on the left to 0.5 m on the right, through the other one in the middle.
    Placed slanted =
        painted(
            plain(RED), new Sheet(new Vec3(1.5, 3, -3), new Vec3(-1, -6, 0), new Vec3(0, 0, 6)));
    Placed upright = painted(plain(GREEN), Sheet.ahead(1, MIDDLE, 6));

    Screen screen = Screen.of(slanted, upright);

    assertThat(screen.rgb(25, 50)).isEqualTo(GREEN & 0xffffff);
    assertThat(screen.rgb(75, 50)).isEqualTo(RED & 0xffffff);
    assertThat(screen.count(RED)).isEqualTo(5000);
    assertThat(screen.count(GREEN)).isEqualTo(5000);
  }

  @Test
  void fromBehindNothingIsSeen() {
    Sheet back = new Sheet(new Vec3(1, -0.5, -0.5), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    assertThat(Screen.of(painted(plain(RED), back)).count(BLACK)).isEqualTo(100 * 100);
  }

  @Test
  void whatIsBehindTheCameraIsNotSeen() {
    Sheet behind = Sheet.ahead(-1, MIDDLE, 1);
    Sheet behindTurned = new Sheet(new Vec3(-1, -0.5, -0.5), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    Screen screen = Screen.of(painted(plain(RED), behind, behindTurned));

    assertThat(screen.count(BLACK)).isEqualTo(100 * 100);
  }

  @Test
  void ofASheetThatPassesThroughTheCamerasPlaneTheFrontIsSeen() {
    // A floor 1 m below the eye, 10 m ahead and 10 m behind.
    Placed floor =
        painted(
            Sketches.chessboard(2, 64),
            new Sheet(new Vec3(-10, 50, -1), new Vec3(0, -100, 0), new Vec3(20, 0, 0), 100, 20));

    Screen screen = Screen.of(floor);

    // Its far edge is 10 m away: 50 / 10 = 5 pixels below the middle.
    assertThat(screen.count(BLACK)).isEqualTo(55 * 100);
    assertThat(screen.rgb(50, 54)).isEqualTo(0);
    assertThat(screen.rgb(50, 55)).isNotEqualTo(0);
    assertThat(screen.rgb(0, 99)).isNotEqualTo(0);
    assertThat(screen.rgb(99, 99)).isNotEqualTo(0);
  }

  @Test
  void aTextureStandsUprightAndIsNotMirrored() {
    // Red and green above, blue and white below.
    Texture four = new Texture(2, 2, new int[] {RED, GREEN, BLUE, WHITE});

    Screen screen = Screen.of(painted(four, Sheet.ahead(1, MIDDLE, 2)));

    // Half a pixel beside the middles of the texture's pixels, 50 pixels apart: 1 % of a neighbour.
    assertThat(channels(screen.rgb(25, 25))).containsExactly(channels(RED), within(8.0));
    assertThat(channels(screen.rgb(75, 25))).containsExactly(channels(GREEN), within(8.0));
    assertThat(channels(screen.rgb(25, 75))).containsExactly(channels(BLUE), within(8.0));
    assertThat(channels(screen.rgb(75, 75))).containsExactly(channels(WHITE), within(8.0));
  }

  @Test
  void scaleMakesAPartLargerAroundItsOrigin() {
    Part square = painted(plain(RED), Sheet.ahead(0, MIDDLE, SIZE)).part();
    Pose ahead = new Pose(new Vec3(1, 0, 0), Attitude.LEVEL);

    assertThat(Screen.of(new Placed(square, ahead, 1, 1)).count(RED)).isEqualTo(10 * 10);
    assertThat(Screen.of(new Placed(square, ahead, 3, 1)).count(RED)).isEqualTo(30 * 30);
  }

  @Test
  void aPartIsSeenAtItsPose() {
    Part square = painted(plain(RED), Sheet.ahead(1, MIDDLE, SIZE)).part();
    // Turned left by 90 degrees, its front is towards y; from there it is moved in front of the
    // eye.
    Pose turned = new Pose(new Vec3(0.5, -1, 0.2), Attitude.ofHeading(Math.PI / 2));
    Attitude alongY = Attitude.ofHeading(Math.PI / 2);

    Screen screen =
        Screen.of(
            new Viewpoint(new Pose(new Vec3(0, -1, 0), alongY), Screen.LENS, 0.1),
            new Placed(square, turned));

    // 1 m ahead (y), 0.5 m to the right (x), 0.2 m up
    assertThat(screen.column(RED)).isCloseTo(50 + 25, within(0.01));
    assertThat(screen.row(RED)).isCloseTo(50 - 10, within(0.01));
  }

  @Test
  void aDecalCoversWhatLiesInItsPlaneButNotWhatStandsOnIt() {
    Sheet floor = new Sheet(new Vec3(0, 5, -1), new Vec3(0, -10, 0), new Vec3(10, 0, 0));
    Sheet spot = new Sheet(new Vec3(1, 0.5, -1), new Vec3(0, -1, 0), new Vec3(4, 0, 0));
    Sheet post = new Sheet(new Vec3(2, 0.25, -1), new Vec3(0, -0.5, 0), new Vec3(0, 0, 0.5));
    Placed decal = new Placed(decal(RED, spot), Sketches.ORIGIN);

    Screen screen = Screen.of(painted(plain(GREEN), floor), decal, painted(plain(BLUE), post));

    Screen alone = Screen.of(decal);
    Screen postAlone = Screen.of(painted(plain(BLUE), post));
    assertThat(screen.count(BLUE)).isEqualTo(postAlone.count(BLUE)).isPositive();
    Screen both = Screen.of(decal, painted(plain(BLUE), post));
    assertThat(alone.count(RED)).isGreaterThan(both.count(RED));
    assertThat(screen.count(RED)).isEqualTo(both.count(RED));
  }

  @Test
  void aTranslucentDecalLetsThroughWhatIsBelow() {
    Sheet sheet = Sheet.ahead(1, MIDDLE, 2);
    Placed below = painted(plain(GREEN), sheet);

    Screen half = Screen.of(below, new Placed(decal(RED, sheet), Sketches.ORIGIN, 1, 0.5));
    Screen none = Screen.of(below, new Placed(decal(RED, sheet), Sketches.ORIGIN, 1, 0));
    Screen quarter =
        Screen.of(below, new Placed(decal(0x80ff0000, sheet), Sketches.ORIGIN, 1, 0.5));

    assertThat(channels(half.rgb(50, 50))).containsExactly(new double[] {127, 127, 0}, within(2.0));
    assertThat(none.count(GREEN)).isEqualTo(100 * 100);
    assertThat(channels(quarter.rgb(50, 50)))
        .containsExactly(new double[] {64, 191, 0}, within(2.0));
  }

  @Test
  void whatIsSheerIsHiddenByWhatStandsInFrontAndHidesNothing() {
    Sheet sheet = Sheet.ahead(1, MIDDLE, 2);
    Placed sheer =
        new Placed(
            new Part(Sketches.mesh(sheet), plain(0x80ff0000), Finish.SHEER), Sketches.ORIGIN);

    Screen behind = Screen.of(sheer, painted(plain(GREEN), Sheet.ahead(2, MIDDLE, 4)));
    Screen inFront = Screen.of(sheer, painted(plain(GREEN), Sheet.ahead(0.5, MIDDLE, 1)));

    assertThat(channels(behind.rgb(50, 50)))
        .containsExactly(new double[] {128, 127, 0}, within(2.0));
    assertThat(inFront.count(GREEN)).isEqualTo(100 * 100);
  }

  @Test
  void aRasterOfAnotherSizeThanTheLensIsRefused() {
    SoftwareCamera camera = new SoftwareCamera(new Props(ColorSpace.RGB));
    Viewpoint viewpoint = new Viewpoint(Sketches.ORIGIN, Screen.LENS, 0.1);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> camera.draw(Sketches.scene(), viewpoint, Raster.forScreen(100, 98)))
        .withMessageContaining("100 by 98");
  }

  private static Part decal(int argb, Sheet sheet) {
    return new Part(Sketches.mesh(sheet), plain(argb), Finish.DECAL);
  }

  private static double[] channels(int rgb) {
    return new double[] {(rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255};
  }
}
