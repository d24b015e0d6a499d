package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;
import static tellosimulator.view.world.SceneFixture.brightness;
import static tellosimulator.view.world.SceneFixture.find;

import java.util.List;
import java.util.Map;
import javafx.scene.Group;
import javafx.scene.Node;
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
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;
import tellosimulator.world.Wind;

/** Obstacles and mission pads in the 3D scene. */
@NeedsDisplay
class FurnitureDisplayTest {

  private static final Shape BOX = new Shape.Box(0.3, 0.4, 0.5);

  @RegisterExtension final SceneFixture fixture = new SceneFixture();

  @BeforeEach
  void follow() {
    fixture.follow();
  }

  @Test
  void anObstacleComesMovesAndGoes() {
    lookAhead();
    furnish(box(new Vec3(0.5, 0.3, 0.5)));
    GoalRegion left = find(fixture.settledPicture(), FurnitureDisplayTest::isRed);
    furnish(box(new Vec3(0.5, -0.3, 0.5)));
    GoalRegion right = find(fixture.settledPicture(), FurnitureDisplayTest::isRed);
    furnish();
    GoalRegion gone = find(fixture.settledPicture(), FurnitureDisplayTest::isRed);

    assertThat(left.count()).isGreaterThan(1000);
    assertThat(left.x()).isLessThan(WIDTH / 2.0);
    // a button of the window hides some pixels
    assertThat(right.count()).isCloseTo(left.count(), within(1500));
    assertThat(right.x()).isGreaterThan(WIDTH / 2.0);
    assertThat(gone.count()).isZero();
  }

  @Test
  void theDronesPictureShowsObstacles() {
    put();
    furnish(box(new Vec3(0.5, 0, 0.5)));
    fixture.pass(0.1);

    assertThat(find(fixture.insetPicture(), FurnitureDisplayTest::isRed).count())
        .isGreaterThan(1000);
  }

  @Test
  void oneSeesThroughARing() {
    lookAhead();
    Image empty = fixture.settledPicture();
    furnish(new Obstacle("gate", new Shape.Ring(0.3, 0.06, 0.8), new Vec3(0.4, 0, 0), 0, red()));
    Image ring = fixture.settledPicture();

    GoalRegion red = find(ring, FurnitureDisplayTest::isRed);
    int x = (int) red.x();
    assertThat(red.count()).isGreaterThan(1000);
    assertThat(red.x()).as("not all segments are red").isBetween(WIDTH * 0.44, WIDTH * 0.56);
    assertThat(ring.getPixelReader().getColor(x, (int) red.y()))
        .isEqualTo(empty.getPixelReader().getColor(x, (int) red.y()));
  }

  @Test
  void whatHasTheSamePaintIsOneNodeAndStaysWhenTheWindChanges() {
    furnish(box(new Vec3(1, 0, 0)), box(new Vec3(1, 1, 0)), box(new Vec3(-1, 1, 0)));
    fixture.pass(0.1);
    List<Node> nodes = nodes();
    fixture.furnish(arena -> arena.withWind(new Wind(new Vec3(1, 0, 0), 0)));
    fixture.pass(0.1);

    assertThat(nodes).hasSize(1);
    assertThat(nodes().get(0)).isSameAs(nodes.get(0));
  }

  @Test
  void aPadOnAWallMovesWithTheWall() {
    MissionPad hanging = new MissionPad(2, Surface.FRONT_WALL, 0, 1, 0);
    fixture.furnish(arena -> arena.withPads(List.of(hanging)));
    lookAhead();
    GoalRegion far = find(fixture.settledPicture(), FurnitureDisplayTest::isBlack);
    fixture.furnish(arena -> arena.withRoom(new Room(5, 3.5, 3)));
    GoalRegion near = find(fixture.settledPicture(), FurnitureDisplayTest::isBlack);

    // The distance is first 2.5 + 0.6 m, then 1.75 + 0.6 m: 1.7 times as large, and less blurred.
    assertThat(far.count()).isGreaterThan(100);
    assertThat(near.count()).isBetween((int) (1.4 * far.count()), 3 * far.count());
    assertThat(near.x()).isBetween(WIDTH * 0.45, WIDTH * 0.55);
    assertThat(near.y()).isLessThan(HEIGHT / 2.0);
  }

  @Test
  void aDroneCastsItsShadowOnTheObstacleBelow() {
    furnish(new Obstacle("table", new Shape.Box(1, 1, 0.4), new Vec3(0, 0, 0), 0, red()));
    fixture.change(() -> fixture.solid("overlay").setVisible(false));
    fixture.put(new Pose(new Vec3(0, 0, 0.8), Attitude.LEVEL), FlightPhase.FLYING);
    fixture.look(RoomView.TOP);
    fixture.settledPicture();
    fixture.change(() -> fixture.solid("drones").setVisible(false));
    Image with = fixture.picture();
    fixture.change(() -> fixture.solid("raised").setVisible(false));
    Image without = fixture.picture();

    assertThat(brightness(with, WIDTH / 2, HEIGHT / 2, 3))
        .isLessThan(brightness(without, WIDTH / 2, HEIGHT / 2, 3) - 0.1);
    assertThat(brightness(without, WIDTH / 2, HEIGHT / 2, 3)).as("the table").isGreaterThan(0.8);
  }

  private List<Node> nodes() {
    return List.copyOf(((Group) fixture.solid("obstacles")).getChildren());
  }

  private void lookAhead() {
    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    put();
  }

  private void put() {
    fixture.put(new Pose(new Vec3(-0.6, 0, 0.9), Attitude.LEVEL), FlightPhase.FLYING);
  }

  private void furnish(Obstacle... obstacles) {
    fixture.furnish(arena -> arena.withObstacles(List.of(obstacles)));
  }

  private static Obstacle box(Vec3 foot) {
    return new Obstacle("box", BOX, foot, 0, red());
  }

  private static ObstacleAppearance red() {
    return new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
  }

  private static boolean isRed(Color color) {
    return color.getRed() > 0.5 && color.getGreen() < 0.2 && color.getBlue() < 0.2;
  }

  private static boolean isBlack(Color color) {
    return color.getBrightness() < 0.2;
  }
}
