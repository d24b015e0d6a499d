package tellosimulator.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import tellosimulator.fault.FaultKind.Range;

/** The page of faults agrees with the table. */
class FaultPageTest {

  private static final Path PAGE = Path.of("docs", "faults.md");

  private static final Pattern ROW = Pattern.compile("(?m)^\\| `([a-z-]+)` \\| .*\\|$");

  private static final Pattern EXAMPLE = Pattern.compile("--fault \"([^\"]+)\"");

  @Test
  void eachFaultHasItsRow() throws IOException {
    assertThat(Files.readString(PAGE))
        .contains(Arrays.stream(FaultKind.values()).map(FaultPageTest::row).toList());
  }

  @Test
  void thePageHasNoRowOfAnythingElse() throws IOException {
    List<String> known =
        Arrays.stream(FaultKind.values()).map(FaultKind::word).collect(Collectors.toList());
    known.addAll(LinkPreset.options());

    Matcher rows = ROW.matcher(Files.readString(PAGE));
    assertThat(rows.results().map(row -> row.group(1))).isSubsetOf(known).isNotEmpty();
  }

  @Test
  void itsExamplesCanBeRead() throws IOException {
    Matcher examples = EXAMPLE.matcher(Files.readString(PAGE));
    assertThat(examples.results().map(example -> Fault.of(example.group(1)))).isNotEmpty();
  }

  private static String row(FaultKind kind) {
    String parameters =
        kind.ranges().stream().map(FaultPageTest::parameter).collect(Collectors.joining("; "));
    return String.format(
        "| `%s` | %s | %s |", kind.word(), kind.words(), parameters.isEmpty() ? "–" : parameters);
  }

  private static String parameter(Range range) {
    return String.format(
        "`%s` %s, usually %s",
        range.parameter().word(), range.words(), range.parameter().unit().write(range.usual()));
  }
}
