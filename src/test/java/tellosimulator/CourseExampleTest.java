package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Grades {@code examples/course} as the page about grading says. */
@Tag("process")
@Tag("slow")
@NeedsTool({Tool.NAMESPACES, Tool.PYTHON, Tool.TAR})
class CourseExampleTest {

  private static final Path COURSE = Path.of("examples", "course");

  @TempDir private Path folder;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int grade(String... words) {
    return Main.run(
        words,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  @Test
  void itsGradesAreTheExpectedOnesAsAWholeAndInParts() throws Exception {
    List<String> all =
        List.of(
            "grade",
            COURSE.resolve("assignment.yaml").toString(),
            COURSE.resolve("hand-ins").toString(),
            "--roster",
            COURSE.resolve("roster.csv").toString());
    String expected = Files.readString(COURSE.resolve("expected.csv"));

    assertThat(grade(with(all, "-o", at("whole"), "--format", "junit,gradescope"))).isZero();
    assertThat(grade(with(all, "-o", at("part-1"), "--shard", "1/2"))).isZero();
    assertThat(grade(with(all, "-o", at("part-2"), "--shard", "2/2"))).isZero();
    assertThat(grade("grade", "--merge", at("part-1"), at("part-2"), "-o", at("merged"))).isZero();

    assertThat(err.toString(StandardCharsets.UTF_8)).isEmpty();
    assertThat(folder.resolve("whole/totals.csv")).hasContent(expected);
    assertThat(folder.resolve("merged/totals.csv")).hasContent(expected);
    assertThat(folder.resolve("merged/index.html"))
        .hasSameTextualContentAs(folder.resolve("whole/index.html"));
    assertThat(out.toString(StandardCharsets.UTF_8))
        .contains("class page: " + folder.resolve("whole/index.html"))
        .contains("junit: " + folder.resolve("whole/junit.xml"))
        .contains("gradescope: " + folder.resolve("whole/gradescope/*/results.json"));
    assertThat(folder.resolve("whole/feedback/Carla/pillar-1-1.html"))
        .content()
        .contains("it was blocked by the obstacle");
  }

  private String at(String name) {
    return folder.resolve(name).toString();
  }

  private static String[] with(List<String> words, String... more) {
    String[] all = words.toArray(new String[words.size() + more.length]);
    System.arraycopy(more, 0, all, words.size(), more.length);
    return all;
  }
}
