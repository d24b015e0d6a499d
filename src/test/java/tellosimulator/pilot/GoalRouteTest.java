package tellosimulator.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.CourseGenerator;
import tellosimulator.scenario.Difficulty;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

class GoalRouteTest {

  @TempDir private Path folder;

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

  @ParameterizedTest
  @EnumSource(names = {"SLALOM", "GATES", "LANDING_PADS"})
  void reachesTheGoalsOfGeneratedCourses(CourseGenerator.Kind kind) throws Exception {
    for (Difficulty difficulty : Difficulty.values()) {
      for (int seed = 1; seed <= 20; seed++) {
        String text = CourseGenerator.generate(kind, difficulty, seed);
        Path file = Files.writeString(folder.resolve("course.yaml"), text);
        Scenario course = ScenarioFile.read(file);
        assertReaches(course.config(), course.challenge(), kind + " " + difficulty + " " + seed);
      }
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
    Goal land = new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(1, 1, 0), 0.3));
    Goal reach = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(-8, 0, 1), 0.3));
    Challenge challenge =
        new Challenge(List.of(land, reach, land), true, OptionalDouble.empty(), true);
    SimConfig hall = SimConfig.DEFAULT.withArena(Arena.DEFAULT.withRoom(new Room(20, 20, 3)));

    assertReaches(hall, challenge, "a landing, a place 9 m away, and a landing again");
  }

  @Test
  void looksAtPostersAndPadsForAsLongAsAsked() {
    List<Poster> posters =
        List.of(
            new Poster(Surface.LEFT_WALL, 0.5, 1.2, 0.3, "left.png"),
            new Poster(Surface.BACK_WALL, -1, 1.5, 1, "large.png"),
            new Poster(Surface.RIGHT_WALL, 1.5, 0.4, 0.3, "low.png"));
    List<MissionPad> pads =
        List.of(
            MissionPad.onFloor(1, new Vec3(1.5, 1, 0), 1),
            new MissionPad(2, Surface.FRONT_WALL, 1, 1, 0));
    Arena arena = Arena.DEFAULT.withDecor(Decor.DEFAULT.withPosters(posters)).withPads(pads);
    List<Goal> goals =
        List.of(
            new Goal.See(Terms.ANY, new Goal.NamedPoster("left")),
            new Goal.See(Terms.ANY, new Goal.NumberedPad(1), 20, 3),
            new Goal.See(Terms.ANY, new Goal.NamedPoster("large"), 50, 5),
            new Goal.See(Terms.ANY, new Goal.NamedPoster("low"), 15, 1),
            new Goal.See(Terms.ANY, new Goal.NumberedPad(2), 40, 2),
            new Goal.Land(Terms.ANY, new GoalRegion(Vec3.ZERO, 0.3)));
    Challenge all = new Challenge(goals, true, OptionalDouble.empty(), true);
    SimConfig config = SimConfig.DEFAULT.withArena(arena);
    assertReaches(config, all, "three posters and two pads");
    assertReaches(
        config.withProduct(Profile.EDU, Behavior.MEASURED),
        all.withGoals(goals.subList(0, 2)),
        "a poster and a pad, with the errors of real drones");
  }

  @Test
  void looksPastAnObstacleAndOnlyAtWhatCanBeSeen() {
    Obstacle pillar =
        new Obstacle(
            "pillar",
            new Shape.Box(0.3, 0.3, 3),
            new Vec3(1.5, 0, 0),
            0,
            ObstacleAppearance.DEFAULT);
    Poster ahead = new Poster(Surface.FRONT_WALL, 0, 1, 0.3, "ahead.png");
    Poster above = new Poster(Surface.CEILING, 0, 0, 0.3, "above.png");
    SimConfig config =
        SimConfig.DEFAULT.withArena(
            Arena.DEFAULT
                .withDecor(Decor.DEFAULT.withPosters(List.of(ahead, above)))
                .withObstacles(List.of(pillar)));
    Goal behind = new Goal.See(Terms.ANY, new Goal.NamedPoster("ahead"));
    Goal overhead = new Goal.See(Terms.ANY, new Goal.NamedPoster("above"));

    assertReaches(config, Challenge.NONE.withGoals(List.of(behind)), "behind a pillar");
    assertThat(route(config, Challenge.NONE.withGoals(List.of(overhead)), 1)).isEmpty();
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
    Goal behind = new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(2, 0, 0), 0.3));
    SimConfig config = SimConfig.DEFAULT.withArena(Arena.DEFAULT.withObstacles(List.of(closed)));

    assertThat(route(config, Challenge.NONE.withGoals(List.of(behind)), 1)).isEmpty();
  }

  @Test
  void thereIsNoRouteThatMustWaitForAnotherDrone() {
    Goal first = new Goal.Land(Terms.of(2), new GoalRegion(Vec3.ZERO, 0.3));
    Goal second = new Goal.Land(Terms.of(1), new GoalRegion(new Vec3(1, 0, 0), 0.3));
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
