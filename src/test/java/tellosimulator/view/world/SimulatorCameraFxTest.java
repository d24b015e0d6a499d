package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Insets;
import javafx.geometry.Point2D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Room;

/** The viewpoints of the camera, and their effect on the image. */
class SimulatorCameraFxTest {

  private static final List<Pose> STARTS =
      List.of(
          new Pose(Vec3.ZERO, Attitude.ofHeading(1)),
          new Pose(new Vec3(-2, -2, 0), Attitude.LEVEL));

  @RegisterExtension
  final SceneFixture fixture = new SceneFixture(SimConfig.DEFAULT.withRoom(Room.DEFAULT, STARTS));

  @ParameterizedTest
  @CsvSource({"5, 5, 3", "4, 6, 3", "30, 8, 5", "200, 200, 200", "5, 100, 10"})
  void theWholeFloorIsInThePictureWhateverItsSize(double width, double depth, double height) {
    fixture.furnish(arena -> arena.withRoom(new Room(width, depth, height)));
    fixture.settle();

    assertFitted(0, WIDTH);
  }

  @ParameterizedTest
  @EnumSource(value = RoomView.class, mode = EnumSource.Mode.EXCLUDE, names = "CHASE")
  void eachViewOfTheRoomShowsAllOfIt(RoomView view) {
    fixture.look(view);

    assertFitted(0, WIDTH);
    assertThat(camera().viewProperty().get()).contains(view);
  }

  @Test
  void theNorthIsUpInTheViewFromAbove() {
    fixture.look(RoomView.TOP);

    assertThat(pixel(new Vec3(2, 0, 0)).getY()).isLessThan(pixel(Vec3.ZERO).getY() - 50);
    assertThat(pixel(new Vec3(0, 2, 0)).getX()).isLessThan(pixel(Vec3.ZERO).getX() - 50);
  }

  @Test
  void whatPanelsCoverIsCountedOutAndTheirGoingIsToo() {
    fixture.change(() -> fixture.scene().setPadding(new Insets(0, 180, 0, 60)));
    fixture.settle();
    assertFitted(60, WIDTH - 180);

    fixture.change(() -> fixture.scene().setPadding(Insets.EMPTY));
    fixture.settle();
    assertFitted(0, WIDTH);
  }

  @Test
  void goalsAreInThePictureToo() {
    Vec3 high = new Vec3(-2, 0, 2.8);
    Goal goal = new Goal.Reach(Terms.ANY, new GoalRegion(high, 0.1));

    fixture.change(() -> fixture.scene().setGoals(List.of(goal)));
    fixture.settle();

    assertThat(seen(high)).isPresent();
  }

  @Test
  void aDroneThatLeavesThePictureIsTakenBackIntoIt() {
    fixture.look(RoomView.START);
    Vec3 high = new Vec3(-2.3, -2.3, 2.9);
    assertThat(seen(high)).isEmpty();

    fixture.put(new Pose(high, Attitude.LEVEL), FlightPhase.FLYING);
    fixture.settle();

    assertThat(seen(high)).isPresent();
  }

  @Test
  void aHandsViewStaysWhateverHappens() {
    fixture.change(() -> camera().turn(50, 20));
    fixture.settle();
    Pose before = camera().pose();

    fixture.furnish(arena -> arena.withRoom(new Room(20, 20, 3)));
    fixture.change(() -> fixture.scene().setPadding(new Insets(0, 180, 0, 0)));
    fixture.put(new Pose(new Vec3(2.4, 2.4, 2.8), Attitude.LEVEL), FlightPhase.FLYING);
    fixture.settle();

    assertThat(camera().pose()).isEqualTo(before);
    assertThat(camera().viewProperty().get()).isEmpty();
  }

  @Test
  void theStartViewComesBackAndFittingKeepsTheDirection() {
    Pose first = camera().pose();
    fixture.change(() -> camera().turn(50, 20));
    fixture.change(() -> camera().zoom(400));
    Attitude turned = camera().pose().attitude();

    fixture.change(fixture.scene()::fit);
    fixture.settle();
    assertThat(camera().pose().attitude()).isEqualTo(turned);
    assertFitted(0, WIDTH);

    fixture.look(RoomView.START);
    assertThat(camera().pose().position().distanceTo(first.position())).isLessThan(1e-9);
    assertThat(camera().pose().attitude()).isEqualTo(first.attitude());
  }

  @Test
  void betweenViewsItGlides() {
    fixture.settle();
    Vec3 before = eye();

    fixture.change(() -> fixture.scene().look(RoomView.SIDE));
    fixture.pass(0.01);
    assertThat(eye().distanceTo(before)).as("it begins at rest").isLessThan(1e-6);
    fixture.pass(0.15);
    Vec3 half = eye();
    assertThat(fixture.scene().camera().glides()).isTrue();
    fixture.pass(0.16);
    Vec3 there = eye();
    fixture.settle();

    assertThat(eye()).isEqualTo(there);
    assertThat(half.distanceTo(before)).isGreaterThan(1);
    assertThat(half.distanceTo(there)).isGreaterThan(1);
  }

  @Test
  void withReducedMotionItJumps() {
    fixture.settle();
    fixture.change(() -> camera().reducedMotionProperty().set(true));

    fixture.change(() -> fixture.scene().look(RoomView.SIDE));
    Vec3 at = eye();
    fixture.settle();

    assertThat(eye()).isEqualTo(at);
  }

  @Test
  void whereItFollowsTheDroneIsInTheMiddleAndTheRoomsSidesAreTheSame() {
    fixture.follow();
    fixture.look(RoomView.SIDE);
    fly(new Vec3(1, 1, 1), 2);

    assertThat(pixel(new Vec3(1, 1, 1.02)).distance(WIDTH / 2.0, HEIGHT / 2.0)).isLessThan(1);
    assertThat(camera().pose().attitude().heading())
        .isCloseTo(RoomView.SIDE.heading(), within(1e-9));

    fixture.change(() -> camera().followingProperty().set(false));
    fixture.settle();
    assertFitted(0, WIDTH);
  }

  @Test
  void aHandsViewStaysWhereItIsWhenItFollowsNoMore() {
    fixture.follow();
    fixture.change(() -> camera().turn(30, 0));
    fly(new Vec3(1, 1, 1), 0);
    Vec3 before = eye();

    fixture.change(() -> camera().followingProperty().set(false));
    fly(new Vec3(-1, 1, 1), 0);

    assertThat(eye().distanceTo(before)).isLessThan(1e-9);
  }

  @Test
  void itChasesFromBehindTheDroneAndTurnsWithIt() {
    fixture.look(RoomView.CHASE);
    for (double heading : new double[] {0, 1.5}) {
      fly(new Vec3(0, 0, 1), heading);

      assertThat(camera().pose().attitude().heading()).isCloseTo(heading, within(1e-6));
      assertThat(pixel(new Vec3(0, 0, 1.02)).distance(WIDTH / 2.0, HEIGHT / 2.0)).isLessThan(1);
    }

    fixture.look(RoomView.FRONT);
    assertFitted(0, WIDTH);
  }

  @Test
  void aChosenDroneThatIsSeenAlreadyMovesNoCameraAndIsMarked() {
    fixture.settle();
    Vec3 before = eye();
    assertThat(mark().isVisible()).isFalse();

    choose(1);

    assertThat(mark().isVisible()).isTrue();
    fixture.settle();
    assertThat(eye()).isEqualTo(before);
    assertThat(mark().isVisible()).isFalse();
  }

  @Test
  void aChosenDroneOutOfSightIsFound() {
    fixture.change(() -> camera().shift(400, 0, 100));
    fixture.change(() -> camera().zoom(600));
    fixture.settle();
    Vec3 other = STARTS.get(1).position();
    assertThat(seen(other)).isEmpty();
    Attitude direction = camera().pose().attitude();

    choose(1);
    fixture.settle();

    assertThat(pixel(other).distance(WIDTH / 2.0, HEIGHT / 2.0)).isLessThan(1);
    assertThat(camera().pose().attitude()).isEqualTo(direction);
  }

  private void choose(int index) {
    fixture.change(
        () ->
            fixture.simulation().selectedProperty().set(fixture.simulation().drones().get(index)));
    fixture.pass(0.01);
  }

  private SelectionOutline mark() {
    return (SelectionOutline) fixture.scene().lookup(".selection-mark").getParent();
  }

  private SimulatorCamera camera() {
    return fixture.scene().camera();
  }

  private Vec3 eye() {
    return camera().pose().position();
  }

  private Optional<Point2D> seen(Vec3 place) {
    return camera().viewpoint().project(place, WIDTH, HEIGHT);
  }

  private Point2D pixel(Vec3 place) {
    return seen(place).orElseThrow();
  }

  private void fly(Vec3 position, double heading) {
    fixture.put(new Pose(position, Attitude.ofHeading(heading)), FlightPhase.FLYING);
    fixture.settle();
  }

  /**
   * Asserts that all corners of the floor are between two columns of the image, which could not be
   * larger.
   */
  private void assertFitted(double left, double right) {
    Room room = fixture.snapshot().room();
    List<Point2D> corners = new ArrayList<>();
    for (double x : new double[] {-room.depth() / 2, room.depth() / 2}) {
      for (double y : new double[] {-room.width() / 2, room.width() / 2}) {
        corners.add(pixel(new Vec3(x, y, 0)));
      }
    }
    assertThat(corners).allMatch(corner -> corner.getX() > left && corner.getX() < right);
    double width = extent(corners.stream().map(Point2D::getX).toList());
    double height = extent(corners.stream().map(Point2D::getY).toList());
    assertThat(Math.max(width / (right - left), height / HEIGHT)).isGreaterThan(0.7);
  }

  private static double extent(List<Double> values) {
    return values.stream().mapToDouble(each -> each).max().orElseThrow()
        - values.stream().mapToDouble(each -> each).min().orElseThrow();
  }
}
