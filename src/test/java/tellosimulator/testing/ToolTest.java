package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Checks that tests start programs only if they declare them, and that a build lists skipped tests.
 */
class ToolTest {

  @TempDir private Path folder;

  @Test
  void aToolIsNotStartedByATestThatDoesNotNameIt() {
    assertThatThrownBy(() -> Tool.SH.command("-c", "true"))
        .isInstanceOf(AssertionError.class)
        .hasMessage("a test starts a program without @NeedsTool(Tool.SH)");
  }

  @Test
  void aJvmIsNotStartedByATestWithoutTheTag() {
    assertThatThrownBy(() -> Jvm.process(List.of(Jvm.java(), "-version")))
        .isInstanceOf(AssertionError.class)
        .hasMessage("a test starts a process without @Tag(\"process\")");
  }

  @Test
  @NeedsTool({Tool.SH, Tool.MKFIFO})
  void aNamedToolIsStarted() throws Exception {
    assertThat(Tool.SH.command("-c", "exit 3").start().waitFor()).isEqualTo(3);
  }

  @Test
  void aMissingToolSkipsATestAndFailsItOnABuildServer() {
    Optional<Tool> missing = Optional.of(Tool.TSHARK);

    assertThat(ToolCondition.verdict(missing, false).isDisabled()).isTrue();
    assertThat(ToolCondition.verdict(missing, false).getReason())
        .hasValue("needs TSHARK: apt-get install tshark");
    assertThatThrownBy(() -> ToolCondition.verdict(missing, true))
        .hasMessageStartingWith("needs TSHARK: apt-get install tshark");
    assertThat(ToolCondition.verdict(Optional.of(Tool.NAMESPACES), true).isDisabled()).isTrue();
    assertThat(ToolCondition.verdict(Optional.empty(), true).isDisabled()).isFalse();
  }

  @Test
  void theSummaryHasALineForEachReason() throws Exception {
    Map<String, Integer> skipped = new TreeMap<>();
    SkippedTests.count(report("needs TSHARK: apt-get install tshark"), skipped);
    SkippedTests.count(report("needs TSHARK: apt-get install tshark"), skipped);
    SkippedTests.count(report("needs a display"), skipped);

    assertThat(SkippedTests.summary(skipped).lines())
        .containsExactly(
            "Skipped tests, and what they need:",
            "    2  needs TSHARK: apt-get install tshark",
            "    1  needs a display");
    assertThat(SkippedTests.summary(Map.of())).isEmpty();
  }

  private Path report(String reason) throws IOException {
    return Files.writeString(
        folder.resolve("TEST-x.xml"),
        "<testsuite><testcase name='a'><skipped message='"
            + reason
            + "'/></testcase>"
            + "<testcase name='b'/></testsuite>");
  }
}
