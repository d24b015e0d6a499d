package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.world.Arena;
import tellosimulator.world.Wind;

/** Flies each scenario that comes with the program: once successfully, and once like a beginner. */
class GalleryTest {

  private static final Path FOLDER = Path.of("src/main/resources/tellosimulator/scenario");

  private final List<SimEvent> news = new ArrayList<>();

  private static List<String> names() {
    return Gallery.NAMES;
  }

  @Test
  void tenScenariosComeWithTheProgramAndAllAreListed() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      assertThat(
              files
                  .map(file -> file.getFileName().toString())
                  .filter(name -> name.endsWith(".yaml"))
                  .map(name -> name.replace(".yaml", "")))
          .containsExactlyInAnyOrderElementsOf(Gallery.NAMES)
          .hasSize(10);
    }
  }

  @ParameterizedTest
  @MethodSource("names")
  void eachHasANameALessonGoalsAndATimeLimit(String name) {
    Scenario scenario = Gallery.find(name).orElseThrow();

    Description description = scenario.description();
    assertThat(description.name().lines()).containsOnlyKeys("en", "de");
    assertThat(description.teaches().lines()).containsOnlyKeys("en", "de");
    assertThat(description.teaches().english()).matches("(to|that) .*").hasSizeLessThan(100);
    assertThat(description.teaches().in(Locale.GERMAN))
        .matches("dass .*|.* zu .*|.*zu[a-z]+en,.*|zu .*")
        .hasSizeLessThan(100);
    assertThat(scenario.challenge().goals()).isNotEmpty();
    assertThat(scenario.challenge().timeLimit()).isPresent();
  }

  @Test
  void theEasiestComeFirst() {
    assertThat(Gallery.NAMES.stream().map(GalleryTest::difficulty)).isSorted();
  }

  private static Difficulty difficulty(String name) {
    return Gallery.find(name).orElseThrow().description().difficulty().orElseThrow();
  }

  @Test
  void thePageListsThemWithWhatTheyTeach() throws IOException {
    String page = Files.readString(Path.of("docs", "scenarios.md")).replace("`go`", "go");
    for (String name : Gallery.NAMES) {
      Description description = Gallery.find(name).orElseThrow().description();
      String title = description.name().english();
      String teaches = description.teaches().english();
      assertThat(page).contains("| `" + name + "` | " + title + " | " + teaches + " |");
    }
  }

  @Test
  void aScenarioIsCalledInTheLanguageOfTheReader() {
    assertThat(Gallery.nameIn("First square", Locale.GERMAN)).isEqualTo("Das erste Quadrat");
    assertThat(Gallery.nameIn("First square", Locale.ENGLISH)).isEqualTo("First square");
    assertThat(Gallery.nameIn("My room", Locale.GERMAN)).isEqualTo("My room");
  }

  @Test
  void eachIsFollowedByTheNextAndTheLastByNone() {
    assertThat(Gallery.next("empty-room")).contains("over-the-wall");
    assertThat(Gallery.next("swarm-stage")).isEmpty();
  }

  @Test
  void aNameThatIsNotThereIsGuessed() {
    assertThat(Gallery.find("slalon")).isEmpty();
    assertThat(Gallery.meant("slalon")).contains("slalom");
  }

  @Test
  void emptyRoom() {
    String[] square = {"forward 100", "ccw 90", "forward 100", "ccw 90", "forward 100"};
    reaches("empty-room", "takeoff; " + String.join("; ", square) + "; ccw 90; forward 100; land");

    String toTheRight = String.join("; ", square).replace("ccw", "cw");
    misses("empty-room", "takeoff; " + toTheRight + "; cw 90; forward 100; land", 1);
  }

  @Test
  void overTheWall() {
    reaches("over-the-wall", "takeoff; up 120; forward 300; land");
    fails("over-the-wall", "takeoff; forward 300; land", "drone 1 touched the obstacle \"wall\"");
  }

  @Test
  void slalom() {
    reaches(
        "slalom",
        "takeoff; go 100 60 0 60; go 100 -120 0 60; go 100 120 0 60; go 100 -60 0 60; land");
    fails("slalom", "takeoff; forward 400; land", "drone 1 touched the obstacle \"first pole\"");
  }

  @Test
  void tableLanding() {
    reaches("table-landing", "takeoff; up 80; forward 150; left 100; land");
    misses("table-landing", "takeoff; up 80; forward 150; left 85; land", 0);
    fails(
        "table-landing",
        "takeoff; forward 150; left 100; land",
        "drone 1 touched the obstacle \"foot of the table\"");
  }

  @Test
  void windowInTheWall() {
    reaches("window-in-the-wall", "takeoff; up 110; left 60; forward 300; land");
    fails(
        "window-in-the-wall",
        "takeoff; up 110; forward 300; land",
        "drone 1 touched the obstacle \"A\"");
  }

  @Test
  void gateRace() {
    String race =
        "takeoff; up 70; forward 150; up 50; forward 200; ccw 90; down 30; forward 200; forward 50;"
            + " land";
    reaches("gate-race", race);
    fails("gate-race", race.replace("takeoff;", "takeoff; speed 15;"), "time is over");
  }

  @Test
  void wind() {
    reaches("wind", "takeoff; forward 322; land");
    misses("wind", "takeoff; forward 300; land", 0);
  }

  @Test
  void onlyTheWindCarriesTheDroneFromItsPlace() {
    Scenario wind = Gallery.find("wind").orElseThrow();
    Arena calm = wind.config().arena().withWind(Wind.CALM);
    Flight flight = flight(wind.withConfig(wind.config().withArena(calm)));

    flight.drones.fly("command", "takeoff", "forward 300", "land");
    assertThat(flight.progress().status()).isEqualTo(Status.REACHED);
  }

  @Test
  void padCourse() {
    reaches(
        "pad-course",
        "mon; mdirection 0; takeoff; up 50; jump 150 0 80 60 0 m1 m2; jump 150 0 80 60 0 m2 m3;"
            + " jump 150 0 80 60 0 m3 m4; land");
    misses(
        "pad-course",
        "mon; mdirection 0; takeoff; up 50; jump 150 0 80 60 0 m1 m2; jump 0 150 80 60 0 m2 m3;"
            + " jump 150 0 80 60 0 m3 m4; land",
        1);
  }

  @Test
  void wallPad() {
    reaches("wall-pad", "mon; mdirection 1; takeoff; up 90; ccw 90; forward 150; sleep 4; land");
    misses("wall-pad", "mon; mdirection 1; takeoff; up 90; cw 90; forward 150; sleep 4; land", 0);
  }

  @Test
  void swarmStage() {
    Flight good = flight("swarm-stage");
    good.drones.flyAll("command", "takeoff");
    good.drones.flyTogether(List.of("up 60", "forward 100", "up 150"));
    good.drones.flyTogether(List.of("right 300", "up 30", "left 300"));
    good.drones.flyAll("land");
    assertThat(good.progress().status()).as("%s", good.progress()).isEqualTo(Status.REACHED);

    Flight bad = flight("swarm-stage");
    bad.drones.flyAll("command", "takeoff");
    bad.drones.flyTogether(List.of("up 60", "forward 100", "up 60"));
    bad.drones.flyTogether(List.of("right 300", "up 30", "left 300"));
    assertThat(bad.progress().status()).as("%s", bad.progress()).isEqualTo(Status.FAILED);
    assertThat(bad.progress().failure().orElseThrow().english()).contains("drone");
  }

  private void reaches(String scenario, String program) {
    Progress progress = flown(scenario, program);
    assertThat(progress.status()).as("%s, %s", progress, news).isEqualTo(Status.REACHED);
  }

  /** Checks that the program ends after reaching only this number of goals. */
  private void misses(String scenario, String program, int reached) {
    Progress progress = flown(scenario, program);
    assertThat(progress.status()).as("%s", progress).isEqualTo(Status.RUNNING);
    assertThat(progress.count()).as("%s", progress).isEqualTo(reached);
  }

  private void fails(String scenario, String program, String reason) {
    Progress progress = flown(scenario, program);
    assertThat(progress.status()).as("%s", progress).isEqualTo(Status.FAILED);
    assertThat(progress.failure().orElseThrow().english()).isEqualTo(reason);
  }

  private Progress flown(String scenario, String program) {
    Flight flight = flight(scenario);
    flight.drones.ask(1, "command");
    for (String command : program.split("; *", -1)) {
      if (command.startsWith("sleep ")) {
        flight.drones.advance(Double.parseDouble(command.substring("sleep ".length())));
      } else {
        flight.drones.ask(1, command);
      }
    }
    return flight.progress();
  }

  private Flight flight(String name) {
    return flight(Gallery.find(name).orElseThrow());
  }

  private Flight flight(Scenario scenario) {
    GoalWatch watch = new GoalWatch(scenario.challenge(), news::add);
    return new Flight(watch, new SimulatedDrones(scenario.config(), List.of(watch)));
  }

  private record Flight(GoalWatch watch, SimulatedDrones drones) {
    Progress progress() {
      return watch.progress();
    }
  }
}
