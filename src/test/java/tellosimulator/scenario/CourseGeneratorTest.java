package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.CourseGenerator.Kind;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacles;

class CourseGeneratorTest {

  private static final int SEEDS = 20;

  private static ScenarioDocument open(String text) throws ScenarioException {
    return ScenarioFile.open(
        "generated.yaml", text.getBytes(StandardCharsets.UTF_8), Path.of(""), OptionalLong.empty());
  }

  @ParameterizedTest
  @EnumSource
  void eachCourseOpensAndHasNoRangesAndAnotherOneForEachSeed(Kind kind) throws Exception {
    for (Difficulty difficulty : Difficulty.values()) {
      Set<Arena> courses = new HashSet<>();
      for (int seed = 1; seed <= SEEDS; seed++) {
        String text = CourseGenerator.generate(kind, difficulty, seed);
        ScenarioDocument course = open(text);
        assertThat(course.varies()).isFalse();
        assertThat(course.scenario().config().seed()).isEqualTo(seed);
        assertThat(course.scenario().description().difficulty()).contains(difficulty);
        assertThat(course.scenario().challenge().goals()).isNotEmpty();
        assertThat(CourseGenerator.generate(kind, difficulty, seed)).isEqualTo(text);
        courses.add(course.scenario().config().arena());
      }
      assertThat(courses).as("small mazes may be equal").hasSizeGreaterThan(SEEDS - 3);
    }
  }

  /** Walks from the middle of a cell to that of the next one if a drone finds no wall between. */
  @Test
  void aWayLeadsThroughEachMaze() throws Exception {
    for (Difficulty difficulty : Difficulty.values()) {
      for (int seed = 1; seed <= SEEDS; seed++) {
        Scenario maze = open(CourseGenerator.generate(Kind.MAZE, difficulty, seed)).scenario();
        Arena arena = maze.config().arena();
        Vec3 start = maze.config().starts().get(0).position();
        assertThat(reached(arena, start)).as("%s %d", difficulty, seed).hasSize(cells(arena));
      }
    }
  }

  private static int cells(Arena arena) {
    int side = (int) Math.round(arena.room().depth() / 1.2);
    return side * side;
  }

  private static Set<List<Long>> reached(Arena arena, Vec3 start) {
    Obstacles walls = Obstacles.of(arena);
    Set<List<Long>> seen = new HashSet<>();
    Deque<Vec3> left = new ArrayDeque<>(List.of(start));
    while (!left.isEmpty()) {
      Vec3 here = left.pop();
      if (!arena.room().contains(here, DroneSpec.COLLIDER)
          || !seen.add(List.of(Math.round(here.x() * 100), Math.round(here.y() * 100)))) {
        continue;
      }
      for (Vec3 way :
          List.of(new Vec3(1, 0, 0), new Vec3(-1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, -1, 0))) {
        if (walls.distance(here.plusScaled(Vec3.UP, 0.5), way, 1.2) >= 1.2) {
          left.push(here.plusScaled(way, 1.2));
        }
      }
    }
    return seen;
  }

  @Test
  void theTextSaysHowItWasMade() {
    List<String> lines =
        new ArrayList<>(
            CourseGenerator.generate(Kind.LANDING_PADS, Difficulty.HARD, 3).lines().toList());

    assertThat(lines)
        .first()
        .asString()
        .contains("generate landing-pads --difficulty hard --seed 3");
    assertThat(lines)
        .contains("seed: 3   # of noise and gusts", "difficulty: hard")
        .noneMatch(line -> line.contains(".."));
  }
}
