package tellosimulator.goal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.Progress.Status;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Poster;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class GoalWatchTest {

  private static final Goal FRONT =
      new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(1, 0, 0.3), 0.1));
  private static final Goal HOME = new Goal.Land(Terms.ANY, new GoalRegion(Vec3.ZERO, 0.1));

  /**
   * A gate half a metre in front of the drone, with an opening from 40 to 160 cm above the floor.
   */
  private static final Obstacle GATE =
      new Obstacle(
          "first",
          new Shape.Frame(1, 1.2, 0.05, 1),
          new Vec3(0.5, 0, 0),
          0,
          ObstacleAppearance.DEFAULT);

  private final List<SimEvent> news = new ArrayList<>();

  @Test
  void placesAreReachedAndTheFlightEndsWithTheLastGoal() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(FRONT, HOME)));
    assertThat(fixture.watch.progress().phrase().english())
        .isEqualTo("goals: 0 of 2 reached after 0.0 s");

    fixture.drones.fly("command", "takeoff", "forward 100");
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.RUNNING);

    fixture.drones.fly("back 100", "land");
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
    assertThat(news)
        .extracting(
            event -> event instanceof SimEvent.ForDrone one ? "drone " + one.drone() : "all")
        .as("drone 1 reached two goals, the end concerns all")
        .containsExactly("drone 1", "drone 1", "all");
    double elapsed = fixture.watch.progress().elapsed();
    assertThat(fixture.watch.progress().reached().get(1)).hasValue(elapsed);

    fixture.drones.advance(5);
    assertThat(fixture.watch.progress().elapsed()).as("the clock has stopped").isEqualTo(elapsed);
  }

  @Test
  void theClockStartsWithTheFirstTakeoff() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(HOME)));
    fixture.drones.fly("command");
    fixture.drones.advance(7);
    assertThat(fixture.watch.progress().elapsed()).isZero();

    fixture.drones.fly("takeoff");
    assertThat(fixture.watch.progress().elapsed()).isBetween(2.0, 4.0);
  }

  @Test
  void whoStandsAtThePlaceOfLandingAndNeverFliesHasNotLanded() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(HOME)));
    fixture.drones.fly("command");
    fixture.drones.advance(1);

    assertThat(fixture.watch.progress().count()).isZero();
  }

  @Test
  void inOrderALaterGoalDoesNotCountBeforeAnEarlierOne() {
    Goal up = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 1), 0.1));
    Challenge challenge = new Challenge(List.of(up, FRONT), true, OptionalDouble.empty(), false);
    Fixture fixture = fixture(Arena.DEFAULT, challenge);

    fixture.drones.fly("command", "takeoff", "forward 100", "back 100");
    assertThat(fixture.watch.progress().count()).isZero();
    fixture.drones.fly("up 70", "down 70", "forward 100");

    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
  }

  @Test
  void aGateIsPassedThroughItsOpeningOnly() {
    Fixture fixture = fixture(gates(), any(List.of(pass(Direction.EITHER))));
    fixture.drones.fly("command", "takeoff", "up 150", "forward 100");
    assertThat(fixture.watch.progress().count()).as("above it, at 180 cm").isZero();

    fixture.drones.fly("back 100", "down 80", "forward 100");
    assertThat(fixture.watch.progress().count()).as("at 100 cm").isEqualTo(1);
  }

  @Test
  void aGateIsPassedInItsDirection() {
    Fixture along = fixture(gates(), any(List.of(pass(Direction.ALONG))));
    along.drones.fly("command", "takeoff", "up 70", "forward 100");
    assertThat(along.watch.progress().count()).isEqualTo(1);

    Fixture against = fixture(gates(), any(List.of(pass(Direction.AGAINST))));
    against.drones.fly("command", "takeoff", "up 70", "forward 100");
    assertThat(against.watch.progress().count()).as("the wrong way").isZero();
    against.drones.fly("back 100");
    assertThat(against.watch.progress().count()).isEqualTo(1);
  }

  @Test
  void inOrderOnePassDoesNotCountTwice() {
    Goal pass = pass(Direction.EITHER);
    Challenge twice = new Challenge(List.of(pass, pass), true, OptionalDouble.empty(), false);
    Fixture fixture = fixture(gates(), twice);
    fixture.drones.fly("command", "takeoff", "up 70", "forward 100");
    assertThat(fixture.watch.progress().count()).isEqualTo(1);

    fixture.drones.fly("back 100");
    assertThat(fixture.watch.progress().count()).isEqualTo(2);
  }

  @Test
  void aPadIsLandedOnWithTheDronesMiddleOverTheCard() {
    MissionPad pad = MissionPad.onFloor(3, new Vec3(1, 0.5, 0), Math.PI / 4);
    Arena arena = Arena.DEFAULT.withPads(List.of(pad));
    Fixture fixture = fixture(arena, any(List.of(new Goal.LandOn(Terms.ANY, 3))));

    fixture.drones.fly("command", "takeoff", "go 100 30 0 100");
    fixture.drones.fly("land");
    assertThat(fixture.watch.progress().count()).as("20 cm beside its middle").isZero();
    fixture.drones.fly("takeoff", "left 20", "land");
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
  }

  @Test
  void hoveringMustLast() {
    Goal hover = new Goal.Hover(Terms.ANY, new GoalRegion(new Vec3(1, 0, 0.3), 0.2), 5);
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(hover)));
    fixture.drones.fly("command", "takeoff", "forward 100");
    fixture.drones.advance(1);
    fixture.drones.fly("up 50", "down 50");
    fixture.drones.advance(1);
    assertThat(fixture.watch.progress().count()).as("twice less than five seconds").isZero();

    fixture.drones.advance(5);
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
  }

  @Test
  void aGoalOfOneDroneIsNotReachedByAnother() {
    Vec3 left = new Vec3(0, 0.3, 0);
    Goal second = new Goal.Land(Terms.of(2), new GoalRegion(left, 0.5));
    SimConfig two =
        SimConfig.DEFAULT.withDrones(
            SimConfig.alike(Formation.row(2, Vec3.ZERO, SimConfig.DEFAULT.arena().room())));
    GoalWatch watch = new GoalWatch(any(List.of(second)), news::add);
    SimulatedDrones drones = new SimulatedDrones(two, List.of(watch));

    drones.fly(1, "command", "takeoff", "land");
    assertThat(watch.progress().count()).isZero();
    drones.fly(2, "command", "takeoff", "left 30", "land");
    assertThat(watch.progress().count()).isEqualTo(1);
  }

  @Test
  void timeRunsOut() {
    Challenge challenge = new Challenge(List.of(HOME), false, OptionalDouble.of(4), false);
    Fixture fixture = fixture(Arena.DEFAULT, challenge);
    fixture.drones.fly("command", "takeoff", "forward 50", "back 50", "land");

    assertThat(fixture.watch.progress().status()).isEqualTo(Status.FAILED);
    assertThat(fixture.watch.progress().phrase().english())
        .isEqualTo("goals: 0 of 1 reached after 4.0 s: time is over");
    assertThat(news).singleElement().extracting(SimEvent::severity).isEqualTo(Severity.WARNING);
  }

  @Test
  void aTouchFailsOnlyWhereNothingMayBeTouched() {
    Goal wall = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(2.4, 0, 0.3), 0.1));
    Fixture free = fixture(Arena.DEFAULT, any(List.of(wall, HOME)));
    free.drones.fly("command", "takeoff", "speed 20", "forward 260");
    assertThat(free.watch.progress().status()).isEqualTo(Status.RUNNING);
    assertThat(free.watch.progress().count()).isEqualTo(1);

    Challenge strict = new Challenge(List.of(wall, HOME), false, OptionalDouble.empty(), true);
    Fixture forbidden = fixture(Arena.DEFAULT, strict);
    forbidden.drones.fly("command", "takeoff", "speed 20", "forward 260");
    assertThat(forbidden.watch.progress().status()).isEqualTo(Status.FAILED);
    assertThat(forbidden.watch.progress().failure().orElseThrow().english())
        .isEqualTo("drone 1 touched the front wall");
  }

  @Test
  void aCrashFailsAlways() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(HOME)));
    fixture.drones.fly("command", "takeoff", "up 150");
    fixture.drones.send(1, "emergency");
    fixture.drones.advance(3);

    assertThat(fixture.watch.progress().failure().orElseThrow().english())
        .isEqualTo("drone 1 crashed into the floor");
  }

  @Test
  void whoIsSwitchedOffInFlightHasFailedHoweverLowItFlew() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(FRONT, HOME)));
    fixture.drones.fly("command", "takeoff");
    fixture.drones.control(new Control.Power(1, false));
    fixture.drones.advance(3);

    assertThat(fixture.watch.progress().failure().orElseThrow().english())
        .isEqualTo("drone 1 was switched off in flight");
    double elapsed = fixture.watch.progress().elapsed();
    fixture.drones.advance(5);
    assertThat(fixture.watch.progress().elapsed()).as("the clock has stopped").isEqualTo(elapsed);
  }

  @Test
  void whoIsSwitchedOffOnTheGroundCanGoOn() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(FRONT, HOME)));
    fixture.drones.fly("command", "takeoff", "land");
    fixture.drones.control(new Control.Power(1, false));
    fixture.drones.advance(3);

    assertThat(fixture.watch.progress().status()).isEqualTo(Status.RUNNING);
  }

  @Test
  void aResetBeginsAnew() {
    Challenge challenge = new Challenge(List.of(FRONT, HOME), false, OptionalDouble.of(4), false);
    Fixture fixture = fixture(Arena.DEFAULT, challenge);
    fixture.drones.fly("command", "takeoff", "forward 100");
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.FAILED);

    fixture.drones.control(new Control.Reset(1));
    assertThat(fixture.watch.progress()).isEqualTo(Progress.start(challenge));
    fixture.drones.advance(10);
    assertThat(fixture.watch.progress().elapsed()).isZero();
    fixture.drones.fly("takeoff");
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.RUNNING);
  }

  @Test
  void somethingElseCanBeAskedFor() {
    Fixture fixture = fixture(Arena.DEFAULT, Challenge.NONE);
    fixture.drones.fly("command", "takeoff", "land");
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.RUNNING);

    fixture.watch.ask(any(List.of(HOME)));
    fixture.drones.fly("takeoff", "land");
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
  }

  @Test
  void aLandingBesideItsPlaceSaysHowFarItWas() {
    Fixture fixture = fixture(Arena.DEFAULT, any(List.of(FRONT, HOME)));
    fixture.drones.fly("command", "takeoff", "forward 26", "land");

    assertThat(missed(fixture))
        .isEqualTo(
            "drone 1 landed at x 26, y 0, 26 cm from the middle of goal 2; up to 10 cm count");
    assertThat(news)
        .singleElement()
        .satisfies(
            event -> assertThat(event.line()).contains("drone 1: landed at x 26, y 0, 26 cm from"));

    fixture.drones.fly("takeoff", "left 30");
    assertThat(missed(fixture)).as("it stays until a goal is reached").contains("landed at x 26");
    fixture.drones.fly("right 30", "forward 74");
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
    assertThat(fixture.watch.progress().miss()).isEmpty();
  }

  @Test
  void aLandingIsJudgedByTheNearestPlaceUnlessThereIsAnOrder() {
    Goal far = new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(1, 0, 0), 0.2));
    List<Goal> goals = List.of(far, HOME);
    Fixture free = fixture(Arena.DEFAULT, any(goals));
    free.drones.fly("command", "takeoff", "left 30", "land");
    assertThat(missed(free)).contains("30 cm from the middle of goal 2;");

    Fixture ordered = fixture(Arena.DEFAULT, any(goals).withInOrder(true));
    ordered.drones.fly("command", "takeoff", "forward 50", "land");
    assertThat(missed(ordered)).contains("50 cm from the middle of goal 1;");
  }

  @Test
  void aLandingBesideAPadSaysHowFarItWas() {
    Arena arena = Arena.DEFAULT.withPads(List.of(MissionPad.onFloor(3, new Vec3(1, 0, 0), 0)));
    Fixture fixture = fixture(arena, any(List.of(new Goal.LandOn(Terms.ANY, 3))));
    fixture.drones.fly("command", "takeoff", "forward 80", "land");

    assertThat(missed(fixture)).contains("20 cm from the middle of goal 1; up to 10 cm count");
  }

  @Test
  void aLandingOrAPassBeforeItsTurnSaysWhatComesFirst() {
    Challenge landing = any(List.of(FRONT, HOME)).withInOrder(true);
    Fixture landed = fixture(Arena.DEFAULT, landing);
    landed.drones.fly("command", "takeoff", "land");
    assertThat(missed(landed)).isEqualTo("drone 1 landed at goal 2, but goal 1 comes first");

    Goal up = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 2), 0.1));
    Challenge passing = any(List.of(up, pass(Direction.EITHER))).withInOrder(true);
    Fixture passed = fixture(gates(), passing);
    passed.drones.fly("command", "takeoff", "up 70", "forward 100");
    assertThat(missed(passed)).isEqualTo("drone 1 flew through gate first, but goal 1 comes first");
  }

  @Test
  void aFlightPastAGateSaysWhereItsOpeningIs() {
    Fixture over = fixture(gates(), any(List.of(pass(Direction.EITHER))));
    over.drones.fly("command", "takeoff", "up 150", "forward 100");
    assertThat(missed(over))
        .as("feet at 180 cm, its centre 2 cm above them")
        .isEqualTo("drone 1 flew past gate first: at z 182 instead of 100, 0 cm beside its middle");

    Fixture far = fixture(gates(), any(List.of(pass(Direction.EITHER))));
    far.drones.fly("command", "takeoff", "left 200", "forward 100");
    assertThat(far.watch.progress().miss()).as("2 m beside it is another way").isEmpty();
  }

  @Test
  void aFlightThroughAGateInTheWrongDirectionSaysSo() {
    Fixture fixture = fixture(gates(), any(List.of(pass(Direction.AGAINST))));
    fixture.drones.fly("command", "takeoff", "up 70", "forward 100");

    assertThat(missed(fixture)).isEqualTo("drone 1 flew through gate first in the wrong direction");
  }

  private static String missed(Fixture fixture) {
    return fixture.watch.progress().miss().orElseThrow().english();
  }

  @Test
  void padsOnWallsAreNotLandedOn() {
    MissionPad pad = new MissionPad(3, Surface.FRONT_WALL, 0, 0.5, 0);
    Arena arena = Arena.DEFAULT.withPads(List.of(pad));
    Fixture fixture = fixture(arena, any(List.of(new Goal.LandOn(Terms.ANY, 3))));
    fixture.drones.fly("command", "takeoff", "land");

    assertThat(fixture.watch.progress().count()).isZero();
  }

  private static Goal pass(Direction direction) {
    return new Goal.Pass(Terms.ANY, "first", direction);
  }

  private static Arena gates() {
    return Arena.DEFAULT.withObstacles(List.of(GATE));
  }

  /** A poster of 40 cm on the front wall, 2.5 m in front of the drone, from 30 to 70 cm high. */
  private static final Poster CAT = new Poster(Surface.FRONT_WALL, 0, 0.5, 0.4, "dir/cat.png");

  private static final Arena GALLERY =
      Arena.DEFAULT.withDecor(Decor.DEFAULT.withPosters(List.of(CAT)));

  /** Seen from the start, the poster takes 0.4 / (2 tan 27.5° · 2.5) = 15 percent. */
  private static Goal see(double percent, double seconds) {
    return new Goal.See(Terms.ANY, new Goal.NamedPoster("cat"), percent, seconds);
  }

  @Test
  void aPosterIsSeenWhenAllOfItIsInThePicture() {
    Fixture fixture = fixture(GALLERY, any(List.of(see(10, 1))));
    fixture.drones.fly("command", "takeoff");
    fixture.drones.advance(3);
    assertThat(fixture.watch.progress().count())
        .as("at 30 cm the picture ends 59 cm above the floor")
        .isZero();

    fixture.drones.fly("cw 180", "up 70");
    fixture.drones.advance(3);
    assertThat(fixture.watch.progress().count()).as("behind the drone").isZero();

    fixture.drones.fly("ccw 180");
    fixture.drones.advance(1.1);
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
    assertThat(news.get(0).line())
        .contains("see poster cat for 1.0 s, at least 10% of the picture's width");
  }

  @Test
  void aPosterThatIsTooSmallIsANearMissOnce() {
    Fixture fixture = fixture(GALLERY, any(List.of(see(20, 1))));
    fixture.drones.fly("command", "takeoff", "up 70");
    fixture.drones.advance(3);

    assertThat(missed(fixture)).isEqualTo("drone 1 saw poster cat, but too small: fly closer");
    assertThat(news).hasSize(1);
    fixture.drones.fly("forward 100"); // 1.5 m away: 25 percent
    fixture.drones.advance(1);
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
  }

  @Test
  void aPosterMustStayInThePicture() {
    Fixture fixture = fixture(GALLERY, any(List.of(see(10, 6))));
    fixture.drones.fly("command", "takeoff", "up 70", "cw 90");
    assertThat(missed(fixture))
        .isEqualTo("drone 1 saw poster cat too briefly: 6.0 s without a break count");
    fixture.drones.fly("ccw 90");
    fixture.drones.advance(3);
    assertThat(fixture.watch.progress().count()).as("twice less than six seconds").isZero();

    fixture.drones.advance(4);
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
  }

  @Test
  void anObstacleHidesWhatIsBehindIt() {
    Obstacle pillar =
        new Obstacle(
            "pillar",
            new Shape.Box(0.1, 0.3, 1.5),
            new Vec3(1.2, 0, 0),
            0,
            ObstacleAppearance.DEFAULT);
    Fixture fixture = fixture(GALLERY.withObstacles(List.of(pillar)), any(List.of(see(10, 1))));
    fixture.drones.fly("command", "takeoff", "up 70");
    fixture.drones.advance(3);
    assertThat(fixture.watch.progress().count()).isZero();
    assertThat(fixture.watch.progress().miss()).isEmpty();

    // from 60 cm aside, the lines to the poster pass the pillar 7 cm beside it or more
    fixture.drones.fly("left 60");
    fixture.drones.advance(1.1);
    assertThat(fixture.watch.progress().count()).isEqualTo(1);
  }

  @Test
  void aPadIsSeenByAFlyingDroneOnTheFloorAndOnWalls() {
    MissionPad floor = MissionPad.onFloor(1, new Vec3(1.2, 0, 0), 0);
    MissionPad wall = new MissionPad(2, Surface.FRONT_WALL, 0.5, 0.5, 1);
    Arena arena = Arena.DEFAULT.withPads(List.of(floor, wall));
    Goal first = new Goal.See(Terms.ANY, new Goal.NumberedPad(1));
    Goal second = new Goal.See(Terms.ANY, new Goal.NumberedPad(2), 7, 1);
    Fixture fixture = fixture(arena, any(List.of(first, second)));
    fixture.drones.fly("command");
    fixture.drones.advance(3);
    assertThat(fixture.watch.progress().count()).as("on the ground").isZero();

    fixture.drones.fly("takeoff");
    fixture.drones.advance(1.1);
    assertThat(fixture.watch.progress().reached().get(0)).isPresent();
    fixture.drones.fly("up 40");
    fixture.drones.advance(1.1);
    assertThat(fixture.watch.progress().status()).isEqualTo(Status.REACHED);
  }

  @Test
  void whatIsSeenBeforeItsTurnDoesNotCount() {
    Challenge challenge =
        new Challenge(List.of(HOME, see(10, 1)), true, OptionalDouble.empty(), false);
    Fixture fixture = fixture(GALLERY, challenge);
    fixture.drones.fly("command", "takeoff", "up 70");

    assertThat(missed(fixture)).isEqualTo("drone 1 saw poster cat, but goal 1 comes first");
  }

  private static Challenge any(List<Goal> goals) {
    return new Challenge(goals, false, OptionalDouble.empty(), false);
  }

  private Fixture fixture(Arena arena, Challenge challenge) {
    GoalWatch watch = new GoalWatch(challenge, news::add);
    return new Fixture(
        watch, new SimulatedDrones(SimConfig.DEFAULT.withArena(arena), List.of(watch)));
  }

  private record Fixture(GoalWatch watch, SimulatedDrones drones) {}
}
