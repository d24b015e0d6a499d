package tellosimulator.grade;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.words.Phrase;

/** Grades hand-ins with simulators that fail. */
class GradingTest {

  @TempDir private Path folder;

  /** The flights in the order in which they were over. */
  private static final class Told implements GradingListener {

    private final List<String> flights = new ArrayList<>();

    @Override
    public void begins(int count) {
      flights.add(count + " flights");
    }

    @Override
    public synchronized void graded(String handIn, GradedFlight flight, boolean kept) {
      flights.add(handIn + ": " + flight.program() + (kept ? " (kept)" : ""));
    }
  }

  @Test
  @Tag("process")
  @NeedsTool(Tool.SH)
  void aSimulatorThatFailsBlocksNoOtherHandInAndIsStartedAgain() throws Exception {
    Grading.Request request = request(Grading.Shard.ALL, "Ann/a.py", "Bob/b.py", "Eve/a.py");
    Path into = request.into();
    List<String> simulator = List.of("sh", "-c", "echo out of memory >&2; exit 70");

    for (int run = 1; run <= 2; run++) {
      Told told = new Told();
      try (Grading grading = Grading.open(request, new ArrayList<>()).orElseThrow()) {
        Grades grades = grading.grade(simulator, 1, weaker -> {}, told);

        assertThat(told.flights)
            .containsExactly(
                "3 flights",
                "Ann: simulator failed",
                "Bob: no entry file" + (run == 1 ? "" : " (kept)"),
                "Eve: simulator failed");
        assertThat(Grades.read(into)).isEqualTo(grades);
        GradedFlight flight = grades.handIns().get(0).flights().get(0);
        assertThat(flight.problem().map(Phrase::english))
            .contains("The flight could not be graded: the simulator failed: out of memory.");
        assertThat(flight.result().of()).isEqualTo(5);
      }
    }
    assertThat(into.resolve("recordings/Ann/course-1-1/flight.json")).doesNotExist();
    assertThat(into.resolve("recordings/Bob/course-1-1/flight.json")).exists();
  }

  @Test
  void aSecondShardIsAddedToTheFirst() throws Exception {
    for (int part = 1; part <= 2; part++) {
      Grading.Request request = request(new Grading.Shard(part, 2), "Ann/b", "Bob/b", "Eve/b");
      try (Grading grading = Grading.open(request, new ArrayList<>()).orElseThrow()) {
        Grades grades = grading.grade(List.of("none"), 1, weaker -> {}, new Told());

        assertThat(grades.complete()).isEqualTo(part == 2);
        assertThat(grades.handIns()).hasSize(part == 2 ? 3 : 2);
        assertThat(grades.titles()).isEqualTo(Map.of("course", "Landing"));
        assertThat(Grades.read(request.into())).isEqualTo(grades);
      }
    }
  }

  private Grading.Request request(Grading.Shard shard, String... handIns) throws IOException {
    Files.writeString(
        folder.resolve("course.yaml"),
        "name: Landing\ngoals:\n  - land: {at: [0, 0], radius: 30, points: 5}\n");
    Path assignment =
        Files.writeString(
            folder.resolve("a.yaml"), "name: A\ncourses: [course.yaml]\nentry: a.py\n");
    for (String file : handIns) {
      Path path = folder.resolve("hand-ins").resolve(file);
      Files.createDirectories(path.getParent());
      Files.writeString(path, "pass\n");
    }
    return new Grading.Request(
        assignment,
        folder.resolve("hand-ins"),
        folder.resolve("grades"),
        Optional.empty(),
        Optional.empty(),
        shard);
  }
}
