package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;

/** Tests courses that are drawn from ranges in scenario files. */
class CourseDrawTest {

  private static final String COURSE =
      """
      obstacles:
        - box: {name: a, at: [-100..-60, -20..20], size: [10, 20..40, 50], heading: -30..30}  # one
        - box: {name: b, at: [60..100, 0], size: [10, 10, 50]}
        - box: {name: c, at: [0, 200], size: [10, 10, 10]}   # fixed
      wind: {speed: 1.5..2, towards: 90}
      """;

  @TempDir private Path folder;

  private static Scenario read(String text, long seed) throws ScenarioException {
    return document(text, OptionalLong.of(seed)).scenario();
  }

  private static ScenarioDocument document(String text, OptionalLong seed)
      throws ScenarioException {
    return ScenarioFile.open("room.yaml", text.getBytes(StandardCharsets.UTF_8), Path.of(""), seed);
  }

  private static String mistake(String text, long seed) {
    return catchThrowableOfType(ScenarioException.class, () -> read(text, seed)).getMessage();
  }

  private static Vec3 cm(Obstacle obstacle) {
    return obstacle.foot().times(100);
  }

  private static List<Obstacle> obstacles(Scenario scenario) {
    return scenario.config().arena().obstacles();
  }

  @Test
  void numbersAreWholeWhereTheEndsAreAndHaveOneMoreDecimalOtherwise() throws Exception {
    Set<Double> xs = new HashSet<>();
    Set<Double> speeds = new HashSet<>();
    for (int seed = 0; seed < 2000; seed++) {
      Scenario drawn = read(COURSE, seed);
      xs.add((double) Math.round(cm(obstacles(drawn).get(1)).x() * 1e6) / 1e6);
      speeds.add((double) Math.round(drawn.config().arena().wind().mean().norm() * 1e8) / 1e6);
    }
    assertThat(xs).hasSize(41).allMatch(x -> x == Math.rint(x) && x >= 60 && x <= 100);
    assertThat(speeds).as("1.50 to 2.00").hasSize(51).contains(1.5, 1.51, 2.0);
  }

  /** The numbers must never change: other machines and versions draw the same course. */
  @Test
  void theSameSeedGivesTheSameCourseEverywhere() throws Exception {
    List<String> drawn = new ArrayList<>();
    for (long seed : new long[] {1, 2, -999_999_999_999_999_999L}) {
      Obstacle box = obstacles(read(COURSE, seed)).get(0);
      drawn.add(
          "%.0f %.0f %.0f %.0f"
              .formatted(
                  cm(box).x(),
                  cm(box).y(),
                  box.shape().size().y() * 100,
                  Math.toDegrees(box.heading())));
    }
    assertThat(drawn).containsExactly("-94 -17 24 -26", "-81 -16 27 -22", "-95 5 39 -6");
  }

  @Test
  void aFilesOwnSeedCountsUnlessAnotherIsGiven() throws Exception {
    Scenario own = document(COURSE + "seed: 7\n", OptionalLong.empty()).scenario();

    assertThat(obstacles(own)).isEqualTo(obstacles(read(COURSE, 7)));
    assertThat(obstacles(read(COURSE + "seed: 7\n", 8))).isEqualTo(obstacles(read(COURSE, 8)));
    assertThat(obstacles(document(COURSE, OptionalLong.empty()).scenario()))
        .as("the default seed")
        .isEqualTo(obstacles(read(COURSE, 1)));
  }

  @Test
  void aChangedItemChangesNoOther() throws Exception {
    String other = "  - box: {name: new, at: [-200..-150, 100], size: [10, 10, 10]}\n";
    String changed = COURSE.replace("obstacles:\n", "obstacles:\n" + other).replace("# one", "# 1");

    assertThat(obstacles(read(changed, 3)).subList(1, 4)).isEqualTo(obstacles(read(COURSE, 3)));
  }

  @Test
  void equalItemsGetNumbersOfTheirOwnAndSharedOnesTheSame() throws Exception {
    String item = "  - cylinder: {at: [-200..200, -200..200], radius: 1, height: 10}\n";
    List<Obstacle> equal = obstacles(read("obstacles:\n" + item + item, 1));
    assertThat(equal.get(0).foot()).isNotEqualTo(equal.get(1).foot());

    Scenario shared =
        read("goals: [{reach: {at: [&x -200..200, 0, 100]}}, {reach: {at: [*x, 0, 50]}}]\n", 5);
    assertThat(shared.challenge().goals())
        .extracting(goal -> ((tellosimulator.goal.Goal.Reach) goal).region().place().x())
        .satisfies(places -> assertThat(new HashSet<>(places)).hasSize(1));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          wind: {speed: 120..80}   | 1:15: expected the smaller number first, as in 80..120, found "120..80"
          wind: {speed: 1..x}      | 1:15: expected a speed in cm/s from 0 to 2000, or a range of them such as 80..120, found "1..x"
          wind: {speed: 0..90000}  | 1:15: expected a speed in cm/s from 0 to 2000, or a range of them such as 80..120, found "0..90000"
          wind: {speed: 1...2}     | 1:15: expected a speed in cm/s from 0 to 2000, or a range of them such as 80..120, found "1...2"
          seed: 1..5               | 1:7: expected a whole number of at most 18 digits, found "1..5"
          pads: [{id: 1..3, at: [0, 0]}] | 1:13: expected a pad from 1 to 8, found "1..3"
          """)
  void aWrongRangeIsASentence(String text, String sentence) {
    assertThat(mistake(text + "\n", 1)).isEqualTo("room.yaml:" + sentence);
  }

  @Test
  void whatOverlapsIsDrawnAgain() throws Exception {
    String crowded =
        """
        obstacles:
          - cylinder: {at: [-60..60, -60..60], radius: 30, height: 100}
          - box: {at: [-60..60, -60..60], size: [60, 60, 100], heading: 0..89}
          - gate: {name: G, at: [-100..100, -100..100], heading: 0..180, shape: ring, diameter: 60,
                   centre: 60}
        pads:
          - {id: 1, at: [-80..80, -80..80]}
          - {id: 2, at: [-80..80, -80..80]}
        drones: [{start: [-100..100, 0]}]
        goals: [{pass: {gate: G}}, {land-on: {pad: 1}}, {reach: {at: [-80..80, 0, 50]}}]
        """;
    for (int seed = 0; seed < 50; seed++) {
      Scenario drawn = read(crowded, seed);
      List<Obstacle> all = obstacles(drawn);
      double apart = all.get(0).foot().distanceTo(all.get(1).foot());
      assertThat(apart).as("radius and half an edge").isGreaterThan(0.3 + 0.3 - 2e-3);
      List<MissionPad> pads = drawn.config().arena().pads();
      assertThat(
              Math.hypot(
                  pads.get(0).along() - pads.get(1).along(),
                  pads.get(0).height() - pads.get(1).height()))
          .isGreaterThanOrEqualTo(MissionPad.EDGE - 1e-9);
    }
  }

  @Test
  void ifNoCourseFitsTheLastReasonIsToldOnce() {
    assertThat(
            mistake(
                """
                obstacles:
                  - box: {name: one, at: [0, 100], size: [50, 50, 50]}
                  - box: {name: two, at: [-5..5, 100], size: [50, 50, 50]}
                """,
                4))
        .isEqualTo(
            "room.yaml:3:5: none of 100 courses drawn from seed 4 fits; in the last one,"
                + " the obstacle \"two\" and the obstacle \"one\" overlap");
  }

  @Test
  void whatNoDrawCanMendIsToldAsInOtherFiles() {
    assertThat(mistake("wind: {speed: 1..2}\ngoals: [{pass: {gate: A}}]\ncolr: 1\n", 1).lines())
        .hasSize(2)
        .noneMatch(line -> line.contains("none of"));
  }

  @Test
  void fixedObstaclesMayOverlapAndWallsMayCross() throws Exception {
    read(
        """
        obstacles:
          - box: {at: [0, 100], size: [50, 50, 50]}
          - box: {at: [10, 100], size: [50, 50, 50]}
          - box: {at: [10, 100], base: 50, size: [50, 50, 20..40]}   # stands on both
          - wall: {from: [0, -200], to: [200, -200], height: 100}
          - wall: {from: [50..100, -250], to: [50, -150], height: 100}
        """,
        1);
  }

  @Test
  void aGateThatIsBlockedIsNotDrawn() {
    assertThat(
            mistake(
                """
                obstacles:
                  - gate: {name: A, at: [0, 0], shape: ring, diameter: 80, centre: 100..110}
                  - box: {name: lid, at: [20, 0], size: [10, 60, 200]}
                drones: [{start: [-100, 0]}]
                goals: [{pass: {gate: A}}]
                """,
                1))
        .contains("5:9: none of 100")
        .contains("no drone can fly through this gate: the obstacle \"lid\" is in the way");
  }

  @Test
  void savingKeepsTheRangesOfWhatWasNotChanged() throws Exception {
    ScenarioDocument document = document(COURSE, OptionalLong.of(9));
    Scenario drawn = document.scenario();
    List<Obstacle> moved = new ArrayList<>(obstacles(drawn));
    moved.set(1, moved.get(1).movedTo(new Vec3(0.7, 0.5, 0), 0));
    moved.remove(2);
    Scenario wanted =
        drawn.withConfig(drawn.config().withArena(drawn.config().arena().withObstacles(moved)));

    ScenarioDocument saved = document.changedTo(wanted, Path.of(""));

    assertThat(new String(saved.bytes().orElseThrow(), StandardCharsets.UTF_8))
        .isEqualTo(
            """
            obstacles:
              - box: {name: a, at: [-100..-60, -20..20], size: [10, 20..40, 50], heading: -30..30}  # one
              - box: {name: b, at: [70, 50], size: [10, 10, 50]}
            wind: {speed: 1.5..2, towards: 90}
            """);
    assertThat(saved.drawnFrom(9, "").scenario()).isEqualTo(saved.scenario()).isEqualTo(wanted);
  }

  @Test
  void anOpenedScenarioIsDrawnFromAnotherSeed() throws Exception {
    Path file = write("range.yaml", COURSE);
    OpenedScenario opened = OpenedScenario.of(ScenarioFile.open(file), file);

    OpenedScenario other = opened.drawnFrom(12);

    assertThat(opened.varies()).isTrue();
    assertThat(other.scenario().config().seed()).isEqualTo(12);
    assertThat(obstacles(other.scenario())).isEqualTo(obstacles(read(COURSE, 12)));
    assertThat(other.document().scenario().config().seed()).as("is not saved").isEqualTo(1);
    OpenedScenario fixed = OpenedScenario.named("slalom");
    assertThat(fixed.varies()).isFalse();
    assertThat(fixed.drawnFrom(12)).isSameAs(fixed);
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }
}
