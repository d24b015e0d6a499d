package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.words.Translation;

/** Reads grades for other systems with other people's libraries. */
@Timeout(120)
class GradeFormatsIT {

  private static final String COUNT =
      """
      import sys
      from junitparser import JUnitXml
      suites = JUnitXml.fromfile(sys.argv[1])
      for suite in suites:
          print(len(suite), sum(1 for case in suite for result in case.result), suite.failures, suite.errors)
      """;

  @TempDir private Path folder;

  @Test
  @NeedsTool(Tool.PYTHON_CLIENTS)
  void junitparserReadsTheSuites() throws Exception {
    ClassReport report =
        new ClassReport(GradesFixture.in(folder), folder, new ReportTexts(Translation.ENGLISH));
    Path file = report.write(GradeFormat.JUNIT).get(0);
    Process process = Tool.PYTHON_CLIENTS.command("-c", COUNT, file.toString()).start();

    // Anna reached both goals, Bob one of two, and Eve's program was not started
    assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).lines())
        .containsExactly("2 0 0 0", "2 1 1 0", "2 2 0 2");
    assertThat(process.waitFor()).isZero();
  }
}
