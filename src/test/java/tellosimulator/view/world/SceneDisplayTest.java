package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;
import static tellosimulator.view.world.SceneFixture.brightness;
import static tellosimulator.view.world.SceneFixture.find;

import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.world.SceneFixture.GoalRegion;
import tellosimulator.world.Walls;

/** The visible content of the 3D scene. */
@NeedsDisplay
class SceneDisplayTest {

  @RegisterExtension final SceneFixture fixture = new SceneFixture();

  @BeforeEach
  void follow() {
    fixture.follow();
  }

  @Test
  void theDroneIsInTheMiddleOfThePicture() {
    fly(new Vec3(0, 0, 1));
    GoalRegion dark = find(fixture.settledPicture(), SceneDisplayTest::isDark);

    assertThat(dark.count()).isGreaterThan(200);
    assertThat(dark.x()).isBetween(WIDTH * 0.45, WIDTH * 0.55);
    assertThat(dark.y()).isBetween(HEIGHT * 0.4, HEIGHT * 0.6);
  }

  @Test
  void smoothEdgesCanBeSwitchedOnAndOff() {
    fly(new Vec3(0, 0, 1));
    fixture.change(() -> fixture.scene().camera().zoomBy(2));
    int plain = find(fixture.settledPicture(), SceneDisplayTest::isDark).count();
    fixture.change(() -> fixture.scene().antialiasingProperty().set(true));
    int smooth = find(fixture.settledPicture(), SceneDisplayTest::isDark).count();
    fixture.change(() -> fixture.scene().antialiasingProperty().set(false));
    int plainAgain = find(fixture.settledPicture(), SceneDisplayTest::isDark).count();

    assertThat(smooth).isBetween(plain / 2, plain - 1);
    assertThat(plainAgain).isBetween(plain - 5, plain + 5);
  }

  @Test
  void seenFromBehindItMovesToTheRightWhenItFliesToItsRight() {
    fly(new Vec3(0, 0, 1));
    fixture.look(RoomView.CHASE);
    GoalRegion before = find(fixture.settledPicture(), SceneDisplayTest::isDark);

    fly(new Vec3(0, -0.2, 1));
    fixture.pass(0.03);
    GoalRegion after = find(fixture.picture(), SceneDisplayTest::isDark);

    assertThat(after.x()).isGreaterThan(before.x() + 20);
    assertThat(find(fixture.settledPicture(), SceneDisplayTest::isDark).x())
        .as("then the camera has followed")
        .isBetween(before.x() - 2, before.x() + 2);
  }

  @Test
  void itCastsAShadowOnTheFloorBelow() {
    fixture.change(() -> fixture.solid("overlay").setVisible(false));
    fixture.decorate(decor -> decor.withGrid(2));
    fly(new Vec3(0.7, 0.6, 0.8));
    fixture.look(RoomView.TOP);
    fixture.settledPicture();
    fixture.change(() -> fixture.solid("drones").setVisible(false));
    Image with = fixture.picture();
    fixture.change(() -> fixture.solid("ground").setVisible(false));
    Image without = fixture.picture();

    assertThat(brightness(with, WIDTH / 2, HEIGHT / 2, 3))
        .isLessThan(brightness(without, WIDTH / 2, HEIGHT / 2, 3) - 0.1);
    assertThat(brightness(with, 20, 20, 3)).isEqualTo(brightness(without, 20, 20, 3));
  }

  @Test
  void theLensIsInFront() {
    fly(new Vec3(0, 0, 1));
    fixture.change(() -> fixture.scene().camera().zoomBy(4));
    fixture.look(RoomView.FRONT);
    GoalRegion front = find(fixture.settledPicture(), SceneDisplayTest::isLens);
    fixture.look(RoomView.CHASE);
    GoalRegion back = find(fixture.settledPicture(), SceneDisplayTest::isLens);

    assertThat(front.count()).isGreaterThan(20);
    assertThat(front.x()).isBetween(WIDTH * 0.4, WIDTH * 0.6);
    assertThat(back.count()).isLessThan(front.count() / 10);
  }

  @Test
  void theFlownPathIsBlueAndCanBeSwitchedOff() {
    for (int i = 0; i <= 20; i++) {
      fly(new Vec3(0, 0.05 * i, 1 + 0.02 * (i % 2)));
      fixture.pass(0.2);
    }
    GoalRegion shown = find(fixture.settledPicture(), SceneDisplayTest::isBlue);
    fixture.change(() -> fixture.scene().trailVisibleProperty().set(false));
    GoalRegion hidden = find(fixture.settledPicture(), SceneDisplayTest::isBlue);

    assertThat(shown.count()).isGreaterThan(hidden.count() + 100);
  }

  @Test
  void aWallBetweenTheCameraAndTheRoomIsNotDrawn() {
    Vec3 nearTheBack = new Vec3(-2, 0, 1);
    fly(nearTheBack);
    fixture.look(RoomView.CHASE);
    GoalRegion near = find(fixture.settledPicture(), SceneDisplayTest::isDark);
    fly(new Vec3(0, 0, 1));
    GoalRegion inTheMiddle = find(fixture.settledPicture(), SceneDisplayTest::isDark);

    // the camera is 1.35 m behind the drone: outside, beyond the wall at x = -2.5 m
    assertThat(fixture.scene().camera().distance()).isGreaterThan(1);
    assertThat(near.count()).isGreaterThan(inTheMiddle.count() / 2);
  }

  @Test
  void fromOutsideOneSeesThatTheRoomEnds() {
    fixture.change(() -> fixture.scene().camera().zoomBy(0.08));
    Image picture = fixture.settledPicture();

    Color outside = picture.getPixelReader().getColor(3, HEIGHT - 4);
    Color floor = picture.getPixelReader().getColor(WIDTH / 2 + 25, HEIGHT / 2 + 5);
    assertThat(outside).isNotEqualTo(floor);
  }

  @Test
  void aDarkWindowHasADimmerRoom() {
    double bright = brightness(fixture.settledPicture(), WIDTH / 2, HEIGHT - 60, 20);
    fixture.change(() -> fixture.scene().dimmedProperty().set(true));
    double dimmed = brightness(fixture.settledPicture(), WIDTH / 2, HEIGHT - 60, 20);

    assertThat(dimmed / bright).isBetween(0.7, 0.86);
  }

  @Test
  void aDistantDroneIsDrawnLargerUntilThatIsSwitchedOff() {
    fly(new Vec3(0, 0, 1));
    fixture.change(() -> fixture.scene().camera().zoomBy(0.25));
    int enlarged = find(fixture.settledPicture(), SceneDisplayTest::isDark).count();
    fixture.change(() -> fixture.scene().dronesEnlargedProperty().set(false));
    int lifeSize = find(fixture.settledPicture(), SceneDisplayTest::isDark).count();

    assertThat(enlarged).isGreaterThan(2 * lifeSize);
  }

  @Test
  void theInsetShowsWhatTheDronesCameraSees() {
    fly(new Vec3(0, 0, 1));
    Image ahead = fixture.insetPicture();

    // floor and front wall, and no part of the drone itself
    assertThat(ahead.getWidth()).isEqualTo(480);
    assertThat(find(ahead, SceneDisplayTest::isDark).count()).isZero();
    assertThat(brightness(ahead, 240, 30, 5)).isGreaterThan(0.7);
  }

  @Test
  void throughTheDronesCameraTheFloorIsBelowAndTiltsWhenTheDroneRolls() {
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    double half = Math.toRadians(20) / 2;
    Attitude rightDown = new Attitude(Math.cos(half), Math.sin(half), 0, 0);
    fixture.put(new Pose(new Vec3(0, 0, 1), rightDown), FlightPhase.FLYING);
    Image picture = fixture.settledPicture();

    GoalRegion left = skirting(picture, 40);
    GoalRegion right = skirting(picture, WIDTH - 40);
    assertThat(left.count()).isPositive();
    assertThat(right.count()).isPositive();
    assertThat(right.y())
        .as("the right side is down, so the world's right is up")
        .isLessThan(left.y() - 40);
  }

  @Test
  void texturedWallsShowWhichIsWhich() {
    fixture.decorate(decor -> decor.withWalls(Walls.TEXTURED));
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));

    assertThat(aheadWhenHeading(0)).as("bricks in front").matches(SceneDisplayTest::isGreenish);
    assertThat(aheadWhenHeading(90)).as("boards at the left").matches(SceneDisplayTest::isWarm);
    assertThat(aheadWhenHeading(180)).as("tiles behind").matches(SceneDisplayTest::isBluish);
  }

  /** The mean colour of the upper half of the drone camera's view. */
  private Color aheadWhenHeading(double degrees) {
    Attitude attitude = Attitude.ofHeading(Math.toRadians(degrees));
    fixture.put(new Pose(new Vec3(0, 0, 1.2), attitude), FlightPhase.FLYING);
    Image picture = fixture.settledPicture();
    double red = 0;
    double green = 0;
    double blue = 0;
    for (int x = 0; x < WIDTH; x++) {
      for (int y = 0; y < HEIGHT / 2; y++) {
        Color color = picture.getPixelReader().getColor(x, y);
        red += color.getRed();
        green += color.getGreen();
        blue += color.getBlue();
      }
    }
    double pixels = WIDTH * HEIGHT / 2.0;
    return Color.color(red / pixels, green / pixels, blue / pixels);
  }

  private static boolean isWarm(Color color) {
    return color.getRed() > 1.03 * color.getGreen() && color.getGreen() > 1.05 * color.getBlue();
  }

  private static boolean isGreenish(Color color) {
    return color.getGreen() > 1.05 * color.getRed() && color.getGreen() > 1.05 * color.getBlue();
  }

  private static boolean isBluish(Color color) {
    return color.getBlue() > 1.1 * color.getGreen() && color.getBlue() > 1.2 * color.getRed();
  }

  @Test
  void aGoalIsABallWhereItIsAndNotInTheDronesPicture() {
    OverlayPictures.assertGoalIsABall(fixture, fixture::settledPicture);
  }

  @Test
  void whereItTouchedSomethingIsRed() {
    OverlayPictures.assertTouchIsRed(fixture, fixture::settledPicture);
  }

  private void fly(Vec3 position) {
    fixture.put(new Pose(position, Attitude.LEVEL), FlightPhase.FLYING);
  }

  /** Finds the skirting board in a column of the image. */
  private static GoalRegion skirting(Image picture, int column) {
    int count = 0;
    double y = 0;
    for (int j = 0; j < HEIGHT; j++) {
      Color color = picture.getPixelReader().getColor(column, j);
      if (color.getBrightness() < 0.6 && color.getBrightness() > 0.5) {
        count++;
        y += j;
      }
    }
    return new GoalRegion(count, column, y / count);
  }

  /** Matches only a drone's body. */
  private static boolean isDark(Color color) {
    return color.getBrightness() < 0.25;
  }

  /** Matches only the glass of the lens. */
  private static boolean isLens(Color color) {
    return color.getBlue() > 1.5 * color.getRed() && color.getBrightness() < 0.5;
  }

  /** Matches only what belongs to the first drone. */
  private static boolean isBlue(Color color) {
    return color.getBlue() > 0.5 && color.getBlue() > 2 * color.getRed();
  }
}
