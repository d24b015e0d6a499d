package tellosimulator.grade;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.Assignment.AssignedCourse;
import tellosimulator.scenario.Assignment.Limits;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Setup;
import tellosimulator.scenario.Assignment.Take;
import tellosimulator.scenario.OpenedScenario;

/** Opens the courses of assignments. */
class SeededCourseTest {

  @TempDir private Path folder;

  private List<SeededCourse> courses(Path course, List<Long> seeds, List<String> errors) {
    Assignment assignment =
        new Assignment(
            "S",
            List.of(new AssignedCourse(course.toString(), seeds)),
            1,
            Take.BEST,
            List.of("fly.py"),
            Optional.empty(),
            Optional.empty(),
            Setup.DEFAULT,
            Limits.DEFAULT,
            Scale.DEFAULT);
    return SeededCourse.of(assignment, errors);
  }

  @Test
  void eachSeedHasTheGoalsThatAreDrawnFromIt() throws Exception {
    Path file =
        Files.writeString(
            folder.resolve("course.yaml"),
            "goals:\n  - reach: {at: [-150..150, 100, 80], radius: 30}\n");
    List<String> errors = new ArrayList<>();

    List<SeededCourse> courses = courses(file, List.of(3L, 4L), errors);

    assertThat(errors).isEmpty();
    assertThat(courses).extracting(SeededCourse::seed).containsExactly(3L, 4L);
    for (SeededCourse course : courses) {
      assertThat(course.unflown().goals())
          .singleElement()
          .extracting(FlightResult.GoalResult::task)
          .isEqualTo(
              OpenedScenario.named(file.toString())
                  .drawnFrom(course.seed())
                  .scenario()
                  .challenge()
                  .goals()
                  .get(0)
                  .phrase()
                  .english());
    }
    assertThat(courses.get(0).unflown()).isNotEqualTo(courses.get(1).unflown());
  }

  @Test
  void withoutSeedsThatOfTheScenarioIsFlown() throws Exception {
    Path file =
        Files.writeString(
            folder.resolve("course.yaml"), "seed: 9\ngoals:\n  - land: {at: [0, 0], radius: 30}\n");

    assertThat(courses(file, List.of(), new ArrayList<>()))
        .extracting(SeededCourse::seed)
        .containsExactly(9L);
  }
}
