package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress.Status;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

class GoalRouteTest {

  private static List<String> forOneDrone() {
    return Gallery.NAMES.stream().filter(name -> !name.equals("swarm-stage")).toList();
  }

  @ParameterizedTest
  @MethodSource("forOneDrone")
  void reachesTheGoalsOfEachScenarioThatComesWithTheProgram(String name) {
    for (Behavior behavior : Behavior.values()) {
      Scenario scenario = Gallery.find(name).orElseThrow();
      assertReaches(
          scenario.config().withProduct(Profile.EDU, behavior), scenario.challenge(), name);
    }
  }

  @Test
  void fliesOverAWallAndLandsBehindIt() {
    Scenario wall = Gallery.find("over-the-wall").orElseThrow();

    assertThat(route(wall.config(), wall.challenge(), 1).orElseThrow())
        .as("130 cm leave 10 cm between the wall and the drone's feet")
        .containsExactly("command", "takeoff", "up 100", "go 300 0 0 60", "down 80", "land");
  }

  @Test
  void takesOffAgainForWhatIsAskedAfterALanding() {
    Goal land = new Goal.Land(OptionalInt.empty(), new GoalRegion(new Vec3(1, 1, 0), 0.3));
    Goal reach = new Goal.Reach(OptionalInt.empty(), new GoalRegion(new Vec3(-8, 0, 1), 0.3));
    Challenge challenge =
        new Challenge(List.of(land, reach, land), true, OptionalDouble.empty(), true);
    SimConfig hall = SimConfig.DEFAULT.withArena(Arena.DEFAULT.withRoom(new Room(20, 20, 3)));

    assertReaches(hall, challenge, "a landing, a place 9 m away, and a landing again");
  }

  @Test
  void thereIsNoRouteToWhereAnotherDroneStands() {
    Scenario swarm = Gallery.find("swarm-stage").orElseThrow();

    assertThat(route(swarm.config(), swarm.challenge(), 1)).isEmpty();
    assertThat(route(swarm.config(), swarm.challenge(), 2).orElseThrow())
        .as("it stays for 3 s by turning, and lands where it is")
        .contains("cw 360");
  }

  @Test
  void thereIsNoRouteThroughAClosedWall() {
    Obstacle closed =
        new Obstacle(
            "closed", new Shape.Box(0.1, 5, 3), new Vec3(1, 0, 0), 0, ObstacleAppearance.DEFAULT);
    Goal behind = new Goal.Land(OptionalInt.empty(), new GoalRegion(new Vec3(2, 0, 0), 0.3));
    SimConfig config = SimConfig.DEFAULT.withArena(Arena.DEFAULT.withObstacles(List.of(closed)));

    assertThat(route(config, Challenge.NONE.withGoals(List.of(behind)), 1)).isEmpty();
  }

  @Test
  void thereIsNoRouteThatMustWaitForAnotherDrone() {
    Goal first = new Goal.Land(OptionalInt.of(2), new GoalRegion(Vec3.ZERO, 0.3));
    Goal second = new Goal.Land(OptionalInt.of(1), new GoalRegion(new Vec3(1, 0, 0), 0.3));
    Challenge any = Challenge.NONE.withGoals(List.of(first, second));

    assertThat(route(SimConfig.DEFAULT, any, 1)).isPresent();
    assertThat(route(SimConfig.DEFAULT, any.withInOrder(true), 1)).isEmpty();
  }

  @Test
  void thereIsNoRouteWhereNothingIsAsked() {
    assertThat(route(SimConfig.DEFAULT, Challenge.NONE, 1)).isEmpty();
  }

  @Test
  void aTourLeavesOutWhatHasNoSpace() {
    Scenario wall = Gallery.find("over-the-wall").orElseThrow();
    GoalWatch watch = new GoalWatch(wall.challenge(), news -> {});
    SimulatedDrones drones = new SimulatedDrones(wall.config(), List.of(watch));
    List<String> tour = new DemoTour(drones.snapshot(), 1).commands();

    drones.fly(1, tour.toArray(String[]::new));
    assertThat(tour).noneMatch(command -> command.startsWith("curve"));
    assertThat(watch.progress().failure()).as("%s", tour).isEmpty();
  }

  private static Optional<List<String>> route(SimConfig config, Challenge challenge, int drone) {
    return GoalRoute.commands(challenge, new SimulatedDrones(config, List.of()).snapshot(), drone);
  }

  private static void assertReaches(SimConfig config, Challenge challenge, String name) {
    GoalWatch watch = new GoalWatch(challenge, news -> {});
    SimulatedDrones drones = new SimulatedDrones(config, List.of(watch));
    List<String> route = GoalRoute.commands(challenge, drones.snapshot(), 1).orElseThrow();
    List<String> replies = drones.fly(1, route.toArray(String[]::new));

    assertThat(replies).as("%s: %s", name, route).containsOnly("ok");
    assertThat(watch.progress().status())
        .as("%s: %s, %s, %s", name, route, watch.progress(), drones.state(1).motion().position())
        .isEqualTo(Status.REACHED);
  }
}
