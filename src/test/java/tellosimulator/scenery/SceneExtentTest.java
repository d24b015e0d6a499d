package tellosimulator.scenery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class SceneExtentTest {

  private static final Arena ROOM = Arena.empty(new Room(6, 4, 3), Decor.DEFAULT);

  @Test
  void theFloorHasItsCorners() {
    assertThat(SceneExtent.floor(ROOM.room()))
        .contains(new Vec3(2, 3, 0), new Vec3(-2, 3, 0), new Vec3(2, -3, 0), new Vec3(-2, -3, 0))
        .allMatch(place -> place.z() == 0);
  }

  @Test
  void thingsAreObstaclesPadsStartsAndGoals() {
    ObstacleAppearance cover = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    Obstacle box = new Obstacle("box", new Shape.Box(0.4, 0.6, 2), new Vec3(1, 1, 0), 0, cover);
    MissionPad pad = new MissionPad(1, Surface.FRONT_WALL, 0, 1.5, 0);
    Arena arena = ROOM.withObstacles(List.of(box)).withPads(List.of(pad));
    Pose start = new Pose(new Vec3(-1, 0, 0), Attitude.LEVEL);
    Goal reach = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 2), 0.3));

    List<Vec3> places = SceneExtent.things(arena, List.of(start), List.of(reach));

    assertHas(places, new Vec3(1.2, 1.3, 2));
    assertHas(places, new Vec3(2, 0.1, 1.6));
    assertHas(places, new Vec3(-1.2, 0.2, 0)); // 20 cm around the start
    assertHas(places, new Vec3(-0.8, -0.2, 1));
    assertHas(places, new Vec3(0, 0, 2.6)); // and its tag
    assertHas(places, new Vec3(0.3, 0, 2));
  }

  @Test
  void aGateHasATagWhereItIsAGoal() {
    ObstacleAppearance cover = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    Obstacle gate =
        new Obstacle("gate", new Shape.Ring(0.4, 0.03, 1.2), new Vec3(0, 0, 0), 0, cover);
    Arena arena = ROOM.withObstacles(List.of(gate));
    Goal pass = new Goal.Pass(Terms.ANY, "gate", Goal.Direction.EITHER);

    double plain =
        highest(
            SceneExtent.things(
                arena,
                List.of(),
                List.of(new Goal.Pass(Terms.ANY, "other", Goal.Direction.EITHER))));
    double tagged = highest(SceneExtent.things(arena, List.of(), List.of(pass)));

    assertThat(tagged - plain).isCloseTo(0.3, within(1e-9));
  }

  @Test
  void aCircleToLandOnIsOnTopOfWhatStandsThere() {
    ObstacleAppearance cover = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    Obstacle box = new Obstacle("box", new Shape.Box(0.6, 0.6, 0.8), Vec3.ZERO, 0, cover);
    Arena arena = ROOM.withObstacles(List.of(box));
    Goal land = new Goal.Land(Terms.ANY, new GoalRegion(Vec3.ZERO, 0.2));

    List<Vec3> places = SceneExtent.things(arena, List.of(), List.of(land));

    assertHas(places, new Vec3(0.2, 0, 0.8));
    assertHas(places, new Vec3(0, 0, 1.4)); // its tag
  }

  private static double highest(List<Vec3> places) {
    return places.stream().mapToDouble(Vec3::z).max().orElseThrow();
  }

  @Test
  void nothingIsAboveTheCeilingWhereADroneTakesOff() {
    Arena low = Arena.empty(new Room(2, 2, 1), Decor.DEFAULT);
    Pose onTable = new Pose(new Vec3(0, 0, 0.7), Attitude.LEVEL);

    assertThat(SceneExtent.things(low, List.of(onTable), List.of()))
        .allMatch(place -> place.z() <= 1);
  }

  private static void assertHas(List<Vec3> places, Vec3 wanted) {
    assertThat(places).anyMatch(place -> place.distanceTo(wanted) < 1e-9);
  }
}
