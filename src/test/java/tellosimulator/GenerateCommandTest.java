package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the subcommand {@code generate} on the command line. */
class GenerateCommandTest {

  @TempDir private Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  @Test
  void theFileIsThatOfTheStandardOutputAndHasNoMistakes() throws Exception {
    Path file = folder.resolve("gates.yaml");

    assertThat(run("generate", "gates", "--seed", "5", "-o", file.toString())).isZero();
    assertThat(out.toString(StandardCharsets.UTF_8)).contains("scenario: " + file);
    out.reset();
    assertThat(run("generate", "gates", "--seed", "5", "--difficulty", "medium")).isZero();

    assertThat(Files.readAllBytes(file)).isEqualTo(out.toByteArray());
    assertThat(run("check", file.toString())).isZero();
    assertThat(err.size()).isZero();
  }

  @Test
  void anExistingFileIsLeftAsItIs() throws Exception {
    Path file = Files.writeString(folder.resolve("mine.yaml"), "{}");

    assertThat(run("generate", "maze", "-o", file.toString())).isEqualTo(1);

    assertThat(file).hasContent("{}");
    assertThat(err.toString(StandardCharsets.UTF_8)).contains(file + " exists already");
  }

  @Test
  void wrongWordsAreASentence() {
    assertThat(run("generate", "labyrinth")).isEqualTo(2);
    assertThat(run("generate")).isEqualTo(2);
    assertThat(run("generate", "maze", "--difficulty", "extreme")).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .hasSize(3)
        .anyMatch(line -> line.contains("one of slalom, gates, search, landing-pads, maze"))
        .anyMatch(line -> line.contains("KIND"))
        .anyMatch(line -> line.contains("one of easy, medium, hard"));
  }
}
