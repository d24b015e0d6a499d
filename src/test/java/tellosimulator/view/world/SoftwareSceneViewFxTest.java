package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;
import static tellosimulator.view.world.SceneFixture.brightness;
import static tellosimulator.view.world.SceneFixture.find;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
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
import tellosimulator.sim.SimConfig;
import tellosimulator.view.world.SceneFixture.GoalRegion;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Walls;

/** The visible content of the room where JavaFX has no 3D, as in this test. */
class SoftwareSceneViewFxTest {

  private static final List<Pose> STARTS =
      List.of(new Pose(Vec3.ZERO, Attitude.LEVEL), new Pose(new Vec3(-1.5, 1, 0), Attitude.LEVEL));

  @RegisterExtension
  final SceneFixture fixture =
      new SceneFixture(
          SimConfig.DEFAULT
              .withRoom(Room.DEFAULT, STARTS)
              .withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN)));

  @BeforeEach
  void follow() {
    fixture.follow();
  }

  @Test
  void theDroneIsInTheMiddleOfTheRoom() {
    fly(new Vec3(0, 0, 1));
    Image picture = fixture.softwarePicture();

    assertThat(picture.getWidth()).isEqualTo(WIDTH);
    assertThat(picture.getHeight()).isEqualTo(HEIGHT);
    assertThat(brightness(picture, 20, 20, 5)).as("a wall").isGreaterThan(0.7);
    GoalRegion drone = find(picture, SoftwareSceneViewFxTest::isDark);
    assertThat(drone.count()).isGreaterThan(200);
    assertThat(drone.x()).isBetween(WIDTH * 0.45, WIDTH * 0.55);
    assertThat(drone.y()).isBetween(HEIGHT * 0.4, HEIGHT * 0.6);
  }

  @Test
  void fromNearerTheDroneIsLarger() {
    fly(new Vec3(0, 0, 1));
    int far = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isDark).count();

    fixture.change(() -> fixture.scene().camera().zoomBy(2));

    // twice as wide and twice as high
    assertThat(find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isDark).count())
        .isBetween(far * 32 / 10, far * 48 / 10);
  }

  @Test
  void obstaclesAndPadsAreThere() {
    fly(new Vec3(0, 0, 1));
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    ObstacleAppearance red = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    Shape shape = new Shape.Box(0.3, 0.3, 0.3);
    fixture.furnish(
        arena ->
            arena
                .withObstacles(List.of(new Obstacle("box", shape, new Vec3(1.2, 0, 0.3), 0, red)))
                .withPads(List.of(MissionPad.onFloor(1, new Vec3(1.6, -0.6, 0), 0))));
    Image picture = fixture.softwarePicture();

    GoalRegion box = find(picture, SoftwareSceneViewFxTest::isRed);
    assertThat(box.count()).isGreaterThan(1000);
    assertThat(box.x()).isBetween(WIDTH * 0.45, WIDTH * 0.55);
    GoalRegion pad = find(picture, SoftwareSceneViewFxTest::isDark);
    assertThat(pad.count()).isGreaterThan(60);
    assertThat(pad.x()).isGreaterThan(WIDTH * 0.6);
  }

  @Test
  void turnedAroundTheDroneOneSeesItsLens() {
    fly(new Vec3(0, 0, 1));
    fixture.change(() -> fixture.scene().camera().zoomBy(4));
    fixture.look(RoomView.CHASE);
    GoalRegion behind = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isLens);
    fixture.change(() -> fixture.scene().camera().turn(600, 0)); // half a turn
    GoalRegion ahead = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isLens);

    assertThat(ahead.count()).isGreaterThan(20);
    assertThat(ahead.x()).isBetween(WIDTH * 0.4, WIDTH * 0.6);
    assertThat(behind.count()).isLessThan(ahead.count() / 10);
  }

  @Test
  void throughTheDronesCameraTheFloorTiltsWithIt() {
    double half = Math.toRadians(20) / 2;
    Attitude rightDown = new Attitude(Math.cos(half), Math.sin(half), 0, 0);
    fixture.put(new Pose(new Vec3(0, 0, 1), rightDown), FlightPhase.FLYING);

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    Image picture = fixture.softwarePicture();

    // the right side is down, so the world's right is up
    assertThat(find(picture, SoftwareSceneViewFxTest::isDark).count()).as("not itself").isZero();
    assertThat(skirting(picture, WIDTH - 40)).isLessThan(skirting(picture, 40) - 40);
  }

  @Test
  void theFlownPathIsBlueAndCanBeSwitchedOff() {
    for (int i = 0; i <= 20; i++) {
      fly(new Vec3(0, 0.05 * i, 1 + 0.02 * (i % 2)));
      fixture.pass(0.2);
    }
    int shown = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isBlue).count();
    fixture.change(() -> fixture.scene().trailVisibleProperty().set(false));
    int hidden = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isBlue).count();

    assertThat(shown).isGreaterThan(hidden + 100);
  }

  @Test
  void severalDronesHaveTheirNumbers() {
    fly(new Vec3(1.6, 0, 1)); // its start, which has the same colour, is out of view
    fixture.change(() -> fixture.scene().trailVisibleProperty().set(false));
    fixture.look(RoomView.TOP);

    GoalRegion disc = find(fixture.softwarePicture(), SoftwareSceneViewFxTest::isBlue);
    // 1.3 times 0.032 of the distance are 22 pixels of 360 at 38 degrees, as it is the selected
    // drone; 7/8 of that are blue: 280 pixels
    assertThat(disc.count()).isBetween(200, 330);
    assertThat(disc.x()).isBetween(WIDTH * 0.45, WIDTH * 0.55);
    assertThat(disc.y()).isBetween(HEIGHT * 0.4, HEIGHT * 0.6);
  }

  @Test
  void aGoalIsABallWhereItIsAndNotInTheDronesPicture() {
    OverlayPictures.assertGoalIsABall(fixture, fixture::softwarePicture);
  }

  @Test
  void whereItTouchedSomethingIsRed() {
    OverlayPictures.assertTouchIsRed(fixture, fixture::softwarePicture);
  }

  private void fly(Vec3 position) {
    fixture.put(new Pose(position, Attitude.LEVEL), FlightPhase.FLYING);
  }

  /** The topmost pixel of the skirting board, which is darker than wall and floor. */
  private static int skirting(Image picture, int column) {
    return IntStream.range(0, HEIGHT)
        .filter(row -> picture.getPixelReader().getColor(column, row).getBrightness() < 0.6)
        .findFirst()
        .orElseThrow();
  }

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

  private static boolean isRed(Color color) {
    return color.getRed() > 0.5 && color.getGreen() < 0.2 && color.getBlue() < 0.2;
  }
}
