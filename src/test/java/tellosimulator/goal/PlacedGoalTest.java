package tellosimulator.goal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.goal.GoalState.ACTIVE;
import static tellosimulator.goal.GoalState.DONE;
import static tellosimulator.goal.GoalState.LATER;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Poster;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class PlacedGoalTest {

  private static final Goal FIRST =
      new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(1, 0, 0.6), 0.4));
  private static final Goal SECOND =
      new Goal.Hover(Terms.ANY, new GoalRegion(new Vec3(0, 1, 0.8), 0.3), 2);
  private static final Goal THIRD =
      new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(1.5, 1, 0), 0.12));

  private static final Obstacle TABLE =
      new Obstacle(
          "table",
          new Shape.Box(0.5, 0.5, 0.6),
          new Vec3(1.5, 1, 0),
          0,
          ObstacleAppearance.DEFAULT);

  /** A gate whose direction is to the left: its x axis is along the room's y. */
  private static final Obstacle GATE =
      new Obstacle(
          "ring",
          new Shape.Ring(0.5, 0.05, 1),
          new Vec3(2, 0, 0),
          Math.PI / 2,
          ObstacleAppearance.DEFAULT);

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          gate-race          | 0 | fly through gate A at x -100, y -100, z 100 cm, in the direction of x
          gate-race          | 2 | fly through gate C at x 150, y 50, z 120 cm, in the direction of y
          gate-race          | 3 | land at x 150, y 150 cm
          window-in-the-wall | 0 | fly through gate A at x 0, y 60, z 150 cm
          pad-course         | 0 | reach x 0, y -150, z 80 cm
          pad-course         | 2 | land on mission pad 4 at x 150, y 0 cm
          table-landing      | 0 | land at x 150, y 100, z 60 cm
          """)
  void aTaskSaysWhereAndHowHighAndInWhichDirection(String name, int index, String task) {
    Scenario scenario = Gallery.find(name).orElseThrow();
    Goal goal = scenario.challenge().goals().get(index);

    assertThat(PlacedGoal.task(goal, scenario.config().arena()).english()).isEqualTo(task);
  }

  @ParameterizedTest
  @CsvSource({
    "0, ALONG, x",
    "180, ALONG, -x",
    "90, AGAINST, -y",
    "-90, ALONG, -y",
    "30, ALONG, 30°"
  })
  void theDirectionOfAGateIsAnAxisOrAHeading(
      double heading, Goal.Direction direction, String said) {
    Obstacle gate =
        new Obstacle(
            "A",
            new Shape.Ring(0.5, 0.05, 1),
            Vec3.ZERO,
            Math.toRadians(heading),
            ObstacleAppearance.DEFAULT);
    Goal pass = new Goal.Pass(Terms.ANY, "A", direction);

    assertThat(PlacedGoal.task(pass, Arena.DEFAULT.withObstacles(List.of(gate))).english())
        .endsWith("in the direction of " + said);
  }

  @Test
  void inOrderOneIsActiveAfterThoseThatAreDoneAndBeforeThoseThatFollow() {
    assertThat(states(true, 0)).containsExactly(ACTIVE, LATER, LATER);
    assertThat(states(true, 1)).containsExactly(DONE, ACTIVE, LATER);
    assertThat(states(true, 3)).containsExactly(DONE, DONE, DONE);
  }

  @Test
  void inAnyOrderAllThatAreLeftAreActive() {
    assertThat(states(false, 1)).containsExactly(DONE, ACTIVE, ACTIVE);
  }

  @Test
  void nothingIsActiveOnceItHasFailed() {
    Progress failed =
        new Progress(challenge(true), reached(1), 7, Optional.of(Phrase.of("time is over")));

    assertThat(PlacedGoal.of(failed, Arena.DEFAULT))
        .extracting(PlacedGoal::state)
        .containsExactly(DONE, LATER, LATER);
  }

  @Test
  void placesToReachAreBallsAndPlacesToLandAreCirclesOnWhatIsThere() {
    Arena arena = Arena.DEFAULT.withObstacles(List.of(TABLE));

    List<PlacedGoal> marks = PlacedGoal.of(progress(true, 0), arena);

    assertThat(marks).extracting(PlacedGoal::number).containsExactly(1, 2, 3);
    assertThat(marks.get(0).place()).isEqualTo(new PlacedGoal.Ball(new Vec3(1, 0, 0.6), 0.4));
    assertThat(marks.get(1).place()).isEqualTo(new PlacedGoal.Ball(new Vec3(0, 1, 0.8), 0.3));
    PlacedGoal.Circle circle = (PlacedGoal.Circle) marks.get(2).place();
    assertThat(circle.middle().distanceTo(new Vec3(1.5, 1, 0.6))).isLessThan(1e-9);
    assertThat(circle.radius()).isEqualTo(0.12);
  }

  @Test
  void aMissionPadHasACircleThroughItsCorners() {
    Goal pad = new Goal.LandOn(Terms.ANY, 4);
    Arena arena = Arena.DEFAULT.withPads(List.of(MissionPad.onFloor(4, new Vec3(1, -1, 0), 0.3)));

    PlacedGoal.Circle circle = (PlacedGoal.Circle) only(pad, arena).place();

    assertThat(circle.middle().distanceTo(new Vec3(1, -1, 0))).isLessThan(1e-9);
    assertThat(circle.radius()).isCloseTo(0.1414, within(1e-4)); // half the diagonal of 20 cm
  }

  @Test
  void theOpeningOfAGateHasAWayIfTheGoalHasOne() {
    assertThat(opening(Direction.EITHER).way()).isEmpty();
    assertThat(opening(Direction.EITHER).middle().distanceTo(new Vec3(2, 0, 1))).isLessThan(1e-9);
    assertThat(opening(Direction.EITHER).top().z()).isEqualTo(1.55, within(1e-9)); // 1 + 0.5 + 0.05
    assertThat(opening(Direction.EITHER).name()).isEqualTo("ring");
    Vec3 along = opening(Direction.ALONG).way().orElseThrow();
    assertThat(along.distanceTo(new Vec3(0, 1, 0))).isLessThan(1e-9);
    Vec3 against = opening(Direction.AGAINST).way().orElseThrow();
    assertThat(against.distanceTo(new Vec3(0, -1, 0))).isLessThan(1e-9);
  }

  @Test
  void whatMustBeSeenIsASquareThatTheTaskDoesNotLocate() {
    Poster cat = new Poster(Surface.LEFT_WALL, 0.5, 1.2, 0.4, "cat.png");
    Arena arena =
        Arena.DEFAULT
            .withDecor(Decor.DEFAULT.withPosters(List.of(cat)))
            .withPads(List.of(MissionPad.onFloor(4, new Vec3(1, -1, 0), 0.3)));
    Goal see = new Goal.See(Terms.ANY, new Goal.NamedPoster("cat"));

    PlacedGoal.Square poster = (PlacedGoal.Square) only(see, arena).place();

    assertThat(poster.middle().distanceTo(new Vec3(0.5, 2.5, 1.2))).isLessThan(1e-9);
    assertThat(poster.out().distanceTo(new Vec3(0, -1, 0))).isLessThan(1e-9);
    assertThat(poster.corners())
        .as("upper left, lower left, lower right, upper right")
        .usingComparatorForType((a, b) -> a.distanceTo(b) < 1e-9 ? 0 : 1, Vec3.class)
        .containsExactly(
            new Vec3(0.3, 2.5, 1.4),
            new Vec3(0.3, 2.5, 1.0),
            new Vec3(0.7, 2.5, 1.0),
            new Vec3(0.7, 2.5, 1.4));
    assertThat(PlacedGoal.task(see, arena)).isEqualTo(see.task());
    assertThat(PlacedGoal.targets(arena).get(new Goal.NumberedPad(4)).edge()).isEqualTo(0.2);
  }

  @Test
  void whatIsNotThereHasNoMark() {
    Challenge challenge =
        new Challenge(
            List.of(
                new Goal.Pass(Terms.ANY, "gone", Direction.EITHER),
                new Goal.LandOn(Terms.ANY, 7),
                new Goal.See(Terms.ANY, new Goal.NamedPoster("gone")),
                FIRST),
            false,
            OptionalDouble.empty(),
            false);

    assertThat(PlacedGoal.of(Progress.start(challenge), Arena.DEFAULT))
        .extracting(PlacedGoal::number)
        .containsExactly(4);
  }

  @Test
  void theNextOneOfADroneIsItsOwnOrThatOfAny() {
    GoalRegion region = new GoalRegion(new Vec3(1, 0, 1), 0.3);
    List<Goal> goals =
        List.of(
            new Goal.Reach(Terms.of(2), region),
            new Goal.Reach(Terms.of(1), region),
            new Goal.Reach(Terms.ANY, region));
    Challenge challenge = new Challenge(goals, false, OptionalDouble.empty(), false);
    List<PlacedGoal> marks = PlacedGoal.of(Progress.start(challenge), Arena.DEFAULT);

    assertThat(PlacedGoal.next(marks, 1)).map(PlacedGoal::number).hasValue(2);
    assertThat(PlacedGoal.next(marks, 2)).map(PlacedGoal::number).hasValue(1);
    assertThat(PlacedGoal.next(marks, 3)).map(PlacedGoal::number).hasValue(3);
    assertThat(PlacedGoal.next(List.of(), 1)).isEmpty();
  }

  private static PlacedGoal.Opening opening(Direction direction) {
    Arena arena = Arena.DEFAULT.withObstacles(List.of(GATE));
    return (PlacedGoal.Opening) only(new Goal.Pass(Terms.ANY, "ring", direction), arena).place();
  }

  private static PlacedGoal only(Goal goal, Arena arena) {
    Challenge challenge = new Challenge(List.of(goal), true, OptionalDouble.empty(), false);
    return PlacedGoal.of(Progress.start(challenge), arena).get(0);
  }

  private static List<GoalState> states(boolean inOrder, int done) {
    return PlacedGoal.of(progress(inOrder, done), Arena.DEFAULT).stream()
        .map(PlacedGoal::state)
        .toList();
  }

  private static Progress progress(boolean inOrder, int done) {
    return new Progress(challenge(inOrder), reached(done), 7, Optional.empty());
  }

  private static Challenge challenge(boolean inOrder) {
    return new Challenge(List.of(FIRST, SECOND, THIRD), inOrder, OptionalDouble.empty(), false);
  }

  private static List<OptionalDouble> reached(int done) {
    return List.of(0, 1, 2).stream()
        .map(i -> i < done ? OptionalDouble.of(i + 1) : OptionalDouble.empty())
        .toList();
  }
}
