package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the subcommand {@code check} on the command line. */
class CheckCommandTest {

  @TempDir private Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private String file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text).toString();
  }

  @Test
  void eachFileIsCheckedAndAllMistakesOfEachAreTold() throws IOException {
    String good = file("good.yaml", "time-limit: 90s\n");
    String bad = file("bad.yaml", "seed: 1.5\nroom: {width: wide}\n");
    String missing = folder.resolve("missing.yaml").toString();
    String picture = Files.write(folder.resolve("x.png"), new byte[] {1}).toString();
    String poster =
        file("poster.yaml", "posters: [{wall: front, height: 100, width: 30, picture: x.png}]\n");

    assertThat(run("check", bad, good, missing, poster)).isEqualTo(2);

    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .containsExactly(good + ": no mistakes");
    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .hasSize(4)
        .anyMatch(line -> line.startsWith(bad + ":1:7: expected a whole number"))
        .anyMatch(line -> line.startsWith(bad + ":2:15: expected a length"))
        .anyMatch(line -> line.startsWith(missing + ": there is no such file"))
        .anyMatch(line -> line.startsWith(poster + ": ") && line.contains(picture));
  }

  @Test
  void coursesOfSomeSeedsAreDrawn() throws IOException {
    String varies = file("varies.yaml", "wind: {speed: 10..20}\n");
    String rarely =
        file(
            "rarely.yaml",
            "obstacles: [{box: {at: [0, 100], size: [50, 50, 50]}},"
                + " {box: {at: [0, 100.0..150.0], size: [50, 50, 50]}}]\n");

    assertThat(run("check", varies)).isZero();
    assertThat(out.toString(StandardCharsets.UTF_8).strip())
        .isEqualTo(varies + ": no mistakes, also with the seeds 1 to 20");
    assertThat(run("check", rarely)).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8))
        .startsWith(rarely + ":1:56: none of 100 courses drawn from seed ");
  }

  @Test
  void filesWithoutMistakesEndWithZero() throws IOException {
    String empty = file("empty.yaml", "{}");

    assertThat(run("check", empty, empty)).isZero();

    assertThat(err.size()).isZero();
  }

  @Test
  void aFileMustBeNamed() {
    assertThat(run("check")).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8)).contains("FILE");
  }
}
