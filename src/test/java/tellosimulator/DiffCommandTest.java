package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.RecordingFixture;

/** Tests the subcommand {@code diff} on the command line. */
class DiffCommandTest {

  @TempDir private Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private String flight(String name) {
    return RecordingFixture.in(folder.resolve(name)).toString();
  }

  @Test
  void aFlightIsLikeItself() {
    assertThat(run("diff", flight("a"), flight("b"))).isZero();
    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .hasSize(9)
        .last()
        .asString()
        .startsWith("0 of 7 commands differ");
  }

  @Test
  void flightsThatDifferEndWithFourAndAPageIfOneIsWanted() {
    String first = flight("a");
    Path second = RecordingFixture.in(folder.resolve("b"));
    new RecordingFixture(second).with("events.jsonl", "");
    Path page = folder.resolve("diff.html");

    assertThat(run("diff", first, second.toString(), "-o", page.toString())).isEqualTo(4);

    assertThat(page).content().contains("<span class=\"badge bad\">7 of 7 commands differ</span>");
    assertThat(out.toString(StandardCharsets.UTF_8)).contains("report: " + page);
  }

  @Test
  void thePageThatCannotBeWrittenTakesNothingFromTheTable() {
    assertThat(run("diff", flight("a"), flight("b"), "-o", folder.toString())).isEqualTo(1);

    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .hasSize(9)
        .last()
        .asString()
        .startsWith("0 of 7 commands differ");
    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualToIgnoringNewLines(
            "The report was not written to %1$s: %1$s is a folder, a pipe or a device, not a file."
                .formatted(folder));
  }

  @Test
  void whatIsMissingOfARecordingIsToldBeforeTheTable() {
    Path cut = RecordingFixture.in(folder.resolve("cut"));
    new RecordingFixture(cut).runWith(",\"ended\":15.0", "");

    assertThat(run("diff", flight("a"), cut.toString())).isZero();

    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .hasSize(10)
        .first()
        .asString()
        .startsWith("remark: " + cut + ": the recording was cut off");
  }

  @Test
  void flightsWithoutACommandAreNotAlike() {
    Path empty = RecordingFixture.in(folder.resolve("empty"));
    new RecordingFixture(empty).with("events.jsonl", "");

    assertThat(run("diff", empty.toString(), empty.toString())).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualToIgnoringNewLines(
            "There is nothing to compare: neither flight has a command besides rc.");
    assertThat(out.toString(StandardCharsets.UTF_8)).doesNotContain("differ");
  }

  @Test
  void whatCannotBeComparedIsASentence() {
    String missing = folder.resolve("missing").toString();

    assertThat(run("diff", flight("a"), missing)).isEqualTo(1);
    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualToIgnoringNewLines(
            "There is no folder " + missing + "; name the folder of a recording.");

    err.reset();
    assertThat(run("diff", flight("a"))).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8)).contains("B");
  }
}
