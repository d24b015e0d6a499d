package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/** Tests the goals and contacts of an overlay. */
class GoalOverlayTest {

  private static final Eye EYE = new Eye(new Pose(new Vec3(-3, 0, 1), Attitude.LEVEL), 0.1);

  /** Two drones. The second one has the default colour of its number, orange. */
  private static final SimSnapshot SNAPSHOT = snapshot();

  private static final Rgb ORANGE = Rgb.of(0xe69f00);
  private static final PlacedGoal.Ball BALL = new PlacedGoal.Ball(new Vec3(1, 0, 1), 0.4);

  private static final Shape.Gate RING = new Shape.Ring(0.5, 0.05, 1);
  private static final Shape.Gate FRAME = new Shape.Frame(1, 0.8, 0.05, 1);

  private final Overlay overlay = new Overlay(SNAPSHOT);
  private final int others = shown().size();

  @Test
  void aBallHasANumberAndALineFromEachDroneThatMayReachIt() {
    show(mark(1, GoalState.ACTIVE, BALL));
    assertThat(shown()).as("ball, number, line to the floor, two lines").hasSize(others + 5);

    overlay.showGoalLine(false);
    assertThat(shown()).as("ball, number, line to the floor").hasSize(others + 3);
  }

  @Test
  void aLineLeadsFromABallInTheAirToTheFloorUntilItIsDone() {
    overlay.showGoalLine(false);
    show(mark(1, GoalState.LATER, BALL));
    Instance faint = plumbLine();
    assertThat(faint.scale().z()).as("from its lower end").isCloseTo(1 - 0.4, within(1e-9));
    show(mark(1, GoalState.ACTIVE, BALL));
    assertThat(strongest(faint)).isLessThan(strongest(plumbLine()));

    show(mark(1, GoalState.DONE, BALL));
    assertThat(shown()).as("ball and number").hasSize(others + 2);
    show(mark(1, GoalState.ACTIVE, new PlacedGoal.Ball(new Vec3(1, 0, 0.3), 0.4)));
    assertThat(shown()).as("ball and number, as it reaches the floor").hasSize(others + 2);
  }

  /** Returns the only instance on the floor below the ball. */
  private Instance plumbLine() {
    return shown().stream()
        .filter(one -> one.pose().position().equals(new Vec3(1, 0, 0)))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void noLineLeadsToWhatIsDoneOrComesLater() {
    show(mark(1, GoalState.DONE, BALL), mark(2, GoalState.LATER, moved(1)));

    assertThat(shown()).as("two balls, two numbers, a line to the floor").hasSize(others + 5);
  }

  @Test
  void doneIsGreenActiveHasTheAccentAndLaterIsGray() {
    overlay.showGoalLine(false);
    for (GoalState state : GoalState.values()) {
      show(mark(1, state, BALL));
      assertThat(count(hasColor(OverlayColors.of(state)))).as(state.name()).isEqualTo(2);
    }
    assertThat(OverlayColors.of(GoalState.DONE).green()).isGreaterThan(100);
    assertThat(OverlayColors.of(GoalState.ACTIVE).blue()).isGreaterThan(200);
  }

  @Test
  void theGoalOfADroneHasItsColorUntilItIsReached() {
    overlay.showGoalLine(false);
    long before = count(hasColor(ORANGE)); // its number
    show(new PlacedGoal(1, OptionalInt.of(2), GoalState.ACTIVE, BALL));
    assertThat(count(hasColor(ORANGE))).isEqualTo(before + 2);

    show(new PlacedGoal(1, OptionalInt.of(2), GoalState.DONE, BALL));
    assertThat(count(hasColor(ORANGE))).isEqualTo(before);
  }

  @Test
  void aCircleIsSeenOnDarkAndOnLightFloorsWhateverItsState() {
    for (GoalState state : GoalState.values()) {
      show(mark(1, state, new PlacedGoal.Circle(new Vec3(1, 1, 0), 0.2)));

      assertThat(shown())
          .anyMatch(one -> has(one, OverlayColors.of(state), 170) && has(one, Rgb.WHITE, 120));
    }
  }

  /** Returns whether a texture has a colour with at least this alpha [0 to 255]. */
  private static boolean has(Instance instance, Rgb color, int opaque) {
    return Arrays.stream(instance.part().material().texture().argbArray())
        .filter(texel -> texel >>> 24 >= opaque)
        .anyMatch(texel -> distance(Rgb.of(texel & 0xffffff), color) <= 8);
  }

  @Test
  void onlyTheCircleThatComesNextShines() {
    overlay.showGoalLine(false);
    PlacedGoal.Circle circle = new PlacedGoal.Circle(new Vec3(1, 1, 0.6), 0.2);
    show(mark(1, GoalState.LATER, circle));
    assertThat(shown()).as("circle and number").hasSize(others + 2);
    assertThat(shown())
        .as("on the table, but above its top")
        .anyMatch(one -> one.pose().position().distanceTo(new Vec3(1, 1, 0.606)) < 1e-9);

    show(mark(1, GoalState.ACTIVE, circle));
    assertThat(shown())
        .as("the light inside and outside, and what shines through")
        .hasSize(others + 5);
  }

  @Test
  void whatMustBeSeenHasAFrameAndANumber() {
    overlay.showGoalLine(false);
    Pose pose = new Pose(new Vec3(2.5, 0, 1), Attitude.LEVEL);
    for (GoalState state : GoalState.values()) {
      show(mark(1, state, new PlacedGoal.Square(pose, 0.3)));
      assertThat(shown()).as(state.name()).hasSize(others + 2);
      assertThat(count(hasColor(OverlayColors.of(state)))).as(state.name()).isEqualTo(2);
    }
  }

  @Test
  void theGateThatComesNextHasAnOutlineAndAnArrowIfThereIsAWay() {
    overlay.showGoalLine(false);
    show(mark(1, GoalState.ACTIVE, gate(Direction.ALONG)));
    assertThat(shown()).as("outline, arrow, number").hasSize(others + 3);
    show(mark(1, GoalState.ACTIVE, gate(Direction.EITHER)));
    assertThat(shown()).as("outline, number").hasSize(others + 2);
    show(mark(1, GoalState.LATER, gate(Direction.ALONG)));
    assertThat(shown()).as("in its own color, with a number").hasSize(others + 1);
  }

  @Test
  void aGateThatIsDoneIsGreenAllAroundItsFrame() {
    overlay.showGoalLine(false);
    for (Shape.Gate shape : List.of(RING, FRAME)) {
      show(mark(1, GoalState.DONE, gate(shape, Direction.ALONG)));
      assertThat(shown()).as("outline and tick, no arrow").hasSize(others + 2);
      assertThat(count(hasColor(OverlayColors.of(GoalState.DONE)))).isEqualTo(2);

      Mesh outline = gateMesh();
      // both are 0.5 + 0.05 m from the middle to the outer edge, and stand off by 0.012 m
      assertThat(extent(outline, Vec3::y)).isCloseTo(2 * (0.55 + 0.012), within(1e-6));
      assertThat(extent(outline, Vec3::x)).as("depth").isCloseTo(0.05 + 0.024, within(1e-3));
    }
  }

  /** Returns the mesh of the only instance at the foot of the gate. */
  private Mesh gateMesh() {
    return shown().stream()
        .filter(one -> one.pose().position().equals(new Vec3(1, 0, 0)))
        .findFirst()
        .orElseThrow()
        .part()
        .mesh();
  }

  private static double extent(Mesh mesh, ToDoubleFunction<Vec3> along) {
    DoubleSummaryStatistics all =
        IntStream.range(0, mesh.positions())
            .mapToObj(mesh::position)
            .mapToDouble(along)
            .summaryStatistics();
    return all.getMax() - all.getMin();
  }

  @Test
  void anArrowPointsWhereOneShallFly() {
    overlay.showGoalLine(false);
    show(mark(1, GoalState.ACTIVE, gate(Direction.AGAINST)));

    Instance arrow =
        shown().stream()
            .filter(one -> one.pose().position().distanceTo(new Vec3(1, 0, 1)) < 1e-9)
            .findFirst()
            .orElseThrow();
    // its mesh points along z
    Vec3 tip = arrow.pose().attitude().toRoom(Vec3.UP);
    assertThat(tip.distanceTo(new Vec3(0, 1, 0))).isLessThan(1e-9);
  }

  @Test
  void aGateThatIsPassedTwiceHasOneOutlineAndTwoNumbersSideBySide() {
    overlay.showGoalLine(false);
    show(
        mark(1, GoalState.DONE, gate(Direction.EITHER)),
        mark(2, GoalState.ACTIVE, gate(Direction.EITHER)));

    assertThat(shown()).hasSize(others + 3);
    assertThat(count(hasColor(OverlayColors.of(GoalState.DONE)))).as("the tick").isEqualTo(1);
    assertThat(count(hasColor(OverlayColors.of(GoalState.ACTIVE)))).isEqualTo(2);
  }

  @Test
  void theFarthestIsDrawnFirstAndNumbersAreInFrontOfTheRoomAndBehindDrones() {
    overlay.showGoalLine(false);
    show(mark(1, GoalState.ACTIVE, BALL), mark(2, GoalState.ACTIVE, moved(2)));

    List<Instance> all = shown();
    List<Instance> balls = all.stream().filter(one -> one.scale().x() == 0.4).toList();
    assertThat(balls.get(0).pose().position().x()).isEqualTo(3);
    assertThat(balls.get(1).pose().position().x()).isEqualTo(1);
    int ofDrones = all.size() - others; // rings and tags of drones come last
    for (Instance number : all.subList(ofDrones - 2, ofDrones)) {
      // the near plane is at 0.1 m, and the tags of goals are in the fourth layer behind it
      assertThat(number.pose().position().distanceTo(EYE.pose().position())).isBetween(0.39, 0.46);
    }
    assertThat(all).allMatch(one -> one.part().material().shading() == Shading.TRANSLUCENT);
  }

  @Test
  void theSameMomentIsTheSameInstances() {
    show(mark(1, GoalState.ACTIVE, BALL), mark(2, GoalState.LATER, gate(Direction.ALONG)));

    assertThat(shown()).isEqualTo(shown());
  }

  @Test
  void touchesAndCrashesAreRed() {
    overlay.show(
        List.of(),
        List.of(
            new ContactDecal(1, new Vec3(1, 0, 1), false),
            new ContactDecal(1, new Vec3(2, 0, 0), true)));

    assertThat(count(hasColor(OverlayColors.CONTACT))).isEqualTo(2);
  }

  @Test
  void aContactStandsOnItsPlaceInFrontOfRingsAndBehindNumbersOfDrones() {
    Vec3 place = new Vec3(1, 0.5, 1);
    overlay.show(List.of(), List.of(new ContactDecal(1, place, false)));

    Instance pin =
        shown().stream().filter(hasColor(OverlayColors.CONTACT)).findFirst().orElseThrow();
    Vec3 camera = EYE.pose().position();
    Vec3 seen = pin.pose().position().minus(camera);
    Vec3 middle = place.plusScaled(Vec3.UP, 0.02).minus(camera); // of the drone
    assertThat(seen.normalized().distanceTo(middle.normalized())).isLessThan(1e-9);
    assertThat(seen.norm()).isBetween(0.2, 0.26);
    assertThat(pin.part().mesh().position(0).z()).as("its tip").isZero();
  }

  @Test
  void numbersOfGoalsAreTheSmallerTheLessTheyMatter() {
    overlay.showGoalLine(false);

    double active = numberSize(GoalState.ACTIVE);
    assertThat(numberSize(GoalState.LATER)).isCloseTo(0.8 * active, within(1e-9));
    assertThat(numberSize(GoalState.DONE)).isCloseTo(0.6 * active, within(1e-9));
  }

  /** Tags have textures of 64 texels. */
  private double numberSize(GoalState state) {
    show(mark(1, state, BALL));
    return shown().stream()
        .filter(one -> one.part().material().texture().width() == 64)
        .filter(hasColor(OverlayColors.of(state)))
        .mapToDouble(one -> one.scale().x())
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theCircleThatComesNextIsFaintlySeenThroughObstacles() {
    overlay.showGoalLine(false);
    show(mark(1, GoalState.ACTIVE, new PlacedGoal.Circle(new Vec3(1, 0, 0), 0.2)));
    Vec3 camera = EYE.pose().position();
    double farthest = camera.distanceTo(new Vec3(1, 0, 0));

    List<Instance> circles =
        shown().stream()
            .filter(one -> one.part().material().texture().width() == 128)
            .filter(one -> one.pose().attitude().equals(Attitude.LEVEL))
            .toList(); // rings are not level
    List<Instance> near =
        circles.stream()
            .filter(one -> camera.distanceTo(one.pose().position()) < farthest / 2)
            .toList();

    assertThat(circles).hasSize(2);
    assertThat(near).hasSize(1);
    assertThat(strongest(near.get(0)))
        .isCloseTo((int) (0.4 * 255), within(15))
        .isLessThan(strongest(circles.get(0)));
  }

  /** Returns the largest alpha of its texture. */
  private static int strongest(Instance instance) {
    return Arrays.stream(instance.part().material().texture().argbArray())
        .map(argb -> argb >>> 24)
        .max()
        .orElseThrow();
  }

  private void show(PlacedGoal... marks) {
    overlay.show(List.of(marks), List.of());
  }

  private List<Instance> shown() {
    return overlay.instances(SNAPSHOT, EYE);
  }

  private long count(Predicate<Instance> wanted) {
    return shown().stream().filter(wanted).count();
  }

  private static Predicate<Instance> hasColor(Rgb color) {
    return instance -> {
      for (int texel : instance.part().material().texture().argbArray()) {
        Rgb found = Rgb.of(texel & 0xffffff);
        if (texel >>> 24 > 0 && distance(found, color) <= 8) { // the middle of a lit ball
          return true;
        }
      }
      return false;
    };
  }

  private static int distance(Rgb one, Rgb other) {
    return Math.abs(one.red() - other.red())
        + Math.abs(one.green() - other.green())
        + Math.abs(one.blue() - other.blue());
  }

  private static PlacedGoal mark(int number, GoalState state, PlacedGoal.Place place) {
    return new PlacedGoal(number, OptionalInt.empty(), state, place);
  }

  private static PlacedGoal.Ball moved(double ahead) {
    return new PlacedGoal.Ball(new Vec3(1 + ahead, 0, 1), 0.4);
  }

  /** Returns a gate whose passage along x leads to the right. */
  private static PlacedGoal.Opening gate(Direction direction) {
    return gate(RING, direction);
  }

  private static PlacedGoal.Opening gate(Shape.Gate shape, Direction direction) {
    Pose foot = new Pose(new Vec3(1, 0, 0), Attitude.ofHeading(-Math.PI / 2));
    return new PlacedGoal.Opening("A", shape, foot, direction);
  }

  private static SimSnapshot snapshot() {
    SimConfig two =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT));
    return new Simulation(two, drone -> datagram -> {}, List.of()).snapshot();
  }
}
