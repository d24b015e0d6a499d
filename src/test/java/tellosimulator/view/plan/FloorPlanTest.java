package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Poster;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;
import tellosimulator.world.Wind;

class FloorPlanTest {

  private static final Obstacle BOX =
      new Obstacle(
          "box 1", new Shape.Box(0.4, 1, 0.5), new Vec3(1, 0, 0), 0, ObstacleAppearance.DEFAULT);

  private static final Goal.Reach REACH =
      new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(1, 0, 1), 0.3));
  private static final Goal.Land LAND =
      new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(0, 1, 0), 0.3));

  private final FloorPlan plan =
      FloorPlans.of(
          Arena.DEFAULT
              .withObstacles(List.of(BOX))
              .withPads(
                  List.of(
                      MissionPad.onFloor(1, new Vec3(0.5, -1, 0), 0.3),
                      new MissionPad(3, Surface.FRONT_WALL, 0, 1.2, 0))),
          List.of(new Pose(Vec3.ZERO, Attitude.LEVEL)));

  @Test
  void everyPieceIsWhereItIsPut() {
    Placement placement = new Placement(new Vec3(-1, 1.5, 0), 0.5);

    for (PlanItem item : List.of(new Start(1), new Pad(1), new ObstacleItem(0))) {
      Placement now = plan.with(item, placement).placement(item);
      assertThat(now.place().distanceTo(placement.place())).as("%s", item).isLessThan(1e-12);
      assertThat(now.heading()).as("%s", item).isCloseTo(0.5, within(1e-12));
    }
    assertThat(plan.items())
        .containsExactly(new Pad(1), new Pad(3), new ObstacleItem(0), new Start(1));
  }

  /**
   * The default room extends from -2.5 to 2.5 m; right is from the view of someone facing the wall.
   */
  @ParameterizedTest
  @CsvSource({
    " 2.4,  1.0, FRONT_WALL, -1.0",
    " 1.0,  2.4, LEFT_WALL,   1.0",
    "-2.4,  1.0, BACK_WALL,   1.0",
    " 1.0, -2.4, RIGHT_WALL, -1.0",
    " 2.5, -2.45, FRONT_WALL, 2.4",
  })
  void aHangingPadGoesAlongTheWalls(double x, double y, Surface wall, double along) {
    MissionPad moved = plan.with(new Pad(3), new Placement(new Vec3(x, y, 1.2), 0)).pad(new Pad(3));

    assertThat(moved.surface()).isEqualTo(wall);
    assertThat(moved.along()).isCloseTo(along, within(1e-9));
    assertThat(moved.height()).isEqualTo(1.2);
  }

  @Test
  void aHangingPadIsSeenAtItsWall() {
    Placement placement = plan.placement(new Pad(3));

    assertThat(placement.place().x()).isCloseTo(2.5 - PlanOutline.HANGING / 2, within(1e-9));
    assertThat(Math.cos(placement.heading()))
        .isCloseTo(-1, within(1e-9)); // looks back into the room
  }

  @Test
  void newThingsGetNamesAndIdsThatAreFree() {
    assertThat(plan.freeName("box")).isEqualTo("box 2");
    assertThat(plan.freeName("ring")).isEqualTo("ring 1");
    assertThat(plan.freePadIds()).startsWith(2);
  }

  @Test
  void piecesAreTakenAway() {
    assertThat(plan.without(new ObstacleItem(0)).arena().obstacles()).isEmpty();
    assertThat(plan.without(new Pad(1)).has(new Pad(1))).isFalse();
    assertThat(plan.without(List.of(new ObstacleItem(0), new Pad(3))).items())
        .containsExactly(new Pad(1), new Start(1));
  }

  @Test
  void goalsAreMovedNumberedAndTakenAway() {
    FloorPlan asked = plan.with(REACH).with(LAND);

    FloorPlan moved = asked.with(new GoalItem(0), new Placement(new Vec3(2, -1, 1.2), 0.7));
    assertThat(moved.goal(new GoalItem(0)))
        .as("as high as before, as it is the placement that says it")
        .isEqualTo(REACH.at(new GoalRegion(new Vec3(2, -1, 1.2), 0.3)));
    assertThat(asked.renumbered(new GoalItem(1), 1).goals()).containsExactly(LAND, REACH);
    assertThat(asked.without(new GoalItem(0)).goals()).containsExactly(LAND);
    assertThat(asked.items()).startsWith(new GoalItem(0), new GoalItem(1), new Pad(1));
  }

  @Test
  void aGoalIsAtTheGateOrPadThatItNames() {
    Obstacle near = gate("near", new Vec3(1, 1, 0));
    Obstacle far = gate("far", new Vec3(-2, -2, 0));
    Goal pass = new Goal.Pass(Terms.ANY, "near", Goal.Direction.ALONG);
    Goal landOn = new Goal.LandOn(Terms.ANY, 1);
    FloorPlan asked = plan.with(near).with(far).with(pass).with(landOn);

    assertThat(asked.placement(new GoalItem(0)).place()).isEqualTo(near.foot());
    assertThat(asked.placement(new GoalItem(1)).place()).isEqualTo(new Vec3(0.5, -1, 0));
    assertThat(asked.with(new GoalItem(0), new Placement(far.foot(), 0))).isEqualTo(asked);
    assertThat(GoalPlacement.renamed(pass, new Vec3(-1, -1, 0), asked))
        .isEqualTo(new Goal.Pass(Terms.ANY, "far", Goal.Direction.ALONG));
    assertThat(GoalPlacement.renamed(landOn, Vec3.ZERO, asked))
        .as("the other pad hangs at a wall")
        .isEqualTo(landOn);
  }

  @Test
  void aGoalIsAtThePosterOrPadToSee() {
    Poster cat = new Poster(Surface.LEFT_WALL, 1, 1, 0.3, "cat.png");
    Goal.See see = new Goal.See(Terms.ANY, new Goal.NamedPoster("cat"), 20, 2);
    FloorPlan asked =
        plan.in(plan.arena().withDecor(Decor.DEFAULT.withPosters(List.of(cat)))).with(see);
    FloorPlan taken = asked.in(asked.arena().withDecor(Decor.DEFAULT));

    assertThat(asked.placement(new GoalItem(0)).place().distanceTo(new Vec3(1, 2.5, 1)))
        .isLessThan(1e-9);
    assertThat(asked.offers(see)).isTrue();
    assertThat(taken.offers(see)).isFalse();
    Goal nearest = GoalPlacement.renamed(see, new Vec3(2, 0.2, 0), asked);
    assertThat(nearest).isEqualTo(see.of(new Goal.NumberedPad(3)));
    assertThat(asked.with(nearest).placement(new GoalItem(1)))
        .isEqualTo(asked.placement(new Pad(3)));
    assertThat(
            PlacementProblem.problemWithGoals(
                asked.with(nearest), asked.with(nearest).without(new Pad(3))))
        .contains(PlacementProblem.NAMED_BY_GOAL);
    assertThat(PaletteItem.SEE.adding(asked, Optional.empty()).orElseThrow().plan().goals())
        .last()
        .isEqualTo(new Goal.See(Terms.ANY, new Goal.NumberedPad(1)));
    FloorPlan bare = taken.without(List.of(new Pad(1), new Pad(3)));
    assertThat(PaletteItem.SEE.adding(bare, Optional.empty())).isEmpty();
  }

  private static Obstacle gate(String name, Vec3 foot) {
    return new Obstacle(name, new Shape.Ring(0.4, 0.05, 1), foot, 0, ObstacleAppearance.DEFAULT);
  }

  /** Of drones 1, 2 and 3, the third one becomes the first: 3, 1, 2. */
  @Test
  void dronesKeepTheirGoalsWithOtherNumbers() {
    FloorPlan three =
        FloorPlans.of(Arena.DEFAULT, List.of(at(0), at(1), at(2)))
            .with(REACH.forDrone(OptionalInt.of(1)))
            .with(REACH.forDrone(OptionalInt.of(3)))
            .with(LAND);

    FloorPlan turned = three.renumbered(new Start(3), 1);

    assertThat(turned.starts()).containsExactly(at(2), at(0), at(1));
    assertThat(turned.goals())
        .extracting(Goal::drone)
        .containsExactly(OptionalInt.of(2), OptionalInt.of(1), OptionalInt.empty());
    FloorPlan two = three.without(List.of(new GoalItem(0), new Start(1)));
    assertThat(two.starts()).containsExactly(at(1), at(2));
    assertThat(two.goals().get(0).drone()).as("once the third").hasValue(2);
  }

  private static Pose at(double x) {
    return new Pose(new Vec3(x, 0, 0), Attitude.LEVEL);
  }

  @Test
  void inAnotherArenaTheWindIsThatOfTheArena() {
    Wind wind = new Wind(new Vec3(1, 0, 0), 0);

    FloorPlan there = plan.in(Arena.DEFAULT.withWind(wind));

    assertThat(there.arena().wind()).isEqualTo(wind);
    assertThat(there.arena().obstacles()).containsExactly(BOX);
  }
}
