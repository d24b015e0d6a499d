package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Model.OptionSpec;
import tellosimulator.cli.Options;
import tellosimulator.scenery.texture.ImageFile;
import tellosimulator.testing.ForPeople;

/** Checks that the program explains any invalid input in words for users. */
class SentencesTest {

  /** With this option, and without a scenario, the program ends before it starts anything. */
  private static final String NEVER_STARTS = "--exit-when-done";

  private static final List<String> VALUES =
      List.of(
          "",
          " ",
          "x",
          "-1",
          "0",
          "1e9",
          "9".repeat(40),
          "{a=b}",
          "[a, b]",
          "a,b,c,d,e",
          "1,2,3,4,5",
          "null",
          "é",
          "\0",
          "@x",
          "/",
          "127.0.0.1:8889",
          "front,1e999,1,1,x.png",
          "1x1x1");

  @TempDir private Path folder;

  static Stream<String> options() {
    return new Options()
        .commandLine(() -> new String[] {""}).getCommandSpec().options().stream()
            .map(OptionSpec::longestName)
            .filter(name -> !List.of("--help", "--version", "--scenarios").contains(name));
  }

  @ParameterizedTest
  @MethodSource("options")
  void whateverAnOptionIsGivenTheAnswerIsForPeople(String option) {
    for (String value : VALUES) {
      checkRefused(NEVER_STARTS, option + "=" + value);
    }
    checkRefused(NEVER_STARTS, option);
    checkRefused(NEVER_STARTS, option + "x");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "%YAML 9.9\n---\nname: a\n",
        "%YAML x\n---\na: b\n",
        "%YAML 1.2\n%YAML 1.2\n---\na: b\n",
        "%TAG ! !\n%TAG ! !\n---\na: b\n",
        "%FOO bar\n---\nname: 1",
        "a: b: c",
        "\ta: b",
        "name: *nothing",
        "name: &a &b c",
        "name: !!java.util.Date x",
        "name: !<x",
        "name: \"\\q\"",
        "name: \"\\ud800\"",
        "name: \"unfinished",
        "name: 'unfinished",
        "name: |9x\n a",
        "name: >\n\t a",
        "name: [a",
        "name: {a",
        "name: a\n...\nname: b\n",
        "name: a\n---\nname: b\n",
        "? [a]\n: b",
        "? {a: b}\n: c",
        "- a\nb: c",
        "name: @x",
        "name: `x`",
        "name: %x",
        "<<: {name: a}",
        "name: a\n name: b",
        "name: ]",
        "}",
        "name: \u0085\u2028",
        "name: \uD83D\uDE00\u0007",
        "drones: 7",
        "drones: [{start: [1]}]",
        "room: ~",
        "goals: [{reach: {at: [0, 0, 1], gate: x}}]",
        "obstacles: [{box: {at: [0, 0], size: 3}}, 7, {}, {box: 1, gate: 2}]"
      })
  void whateverIsInAScenarioTheAnswerIsForPeople(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("room.yaml"), text);

    checkRefused(NEVER_STARTS, "--scenario=" + file);
  }

  @ParameterizedTest
  @ValueSource(strings = {"89504e470d0a1a0a", "ffd8ffe0", "474946383961", "424d", "49492a00", ""})
  void whateverIsInAPictureTheAnswerIsForPeople(String signature) throws IOException {
    byte[] begin = HexFormat.of().parseHex(signature);
    SplittableRandom random = new SplittableRandom(5);
    Path file = folder.resolve("picture");
    for (int i = 0; i < 50; i++) {
      byte[] bytes = new byte[begin.length + i * 7];
      random.nextBytes(bytes);
      System.arraycopy(begin, 0, bytes, 0, begin.length);
      Files.write(file, bytes);

      String picture = file.toString();
      assertThatThrownBy(() -> ImageFile.read(picture))
          .isInstanceOf(IOException.class)
          .satisfies(refused -> ForPeople.check(refused.getMessage()))
          .hasMessageContaining(picture);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "expected YAML, found Version{major=9, minor=9}",
        "java.io.IOException: no",
        "found Object@1a2b3c",
        "found Optional[a]",
        "found Point[x=1]",
        "it is null"
      })
  void namesOfJavaAreFound(String sentence) {
    assertThatThrownBy(() -> ForPeople.check(sentence)).isInstanceOf(AssertionError.class);
  }

  @Test
  void optionsThatAreNoneAreForPeople() {
    for (String value : VALUES) {
      checkRefused(NEVER_STARTS, "-" + value);
      checkRefused(NEVER_STARTS, "--" + value);
    }
  }

  private static void checkRefused(String... arguments) {
    String sentence = refusal(arguments);

    assertThat(sentence).as("%s", List.of(arguments)).isNotBlank().hasSizeLessThan(2000);
    String given = arguments[1].substring(arguments[1].indexOf('=') + 1);
    ForPeople.check(given.isEmpty() ? sentence : sentence.replace(given, "…"));
  }

  private static String refusal(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int status =
        Main.run(
            arguments,
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));

    assertThat(status).as("%s", List.of(arguments)).isEqualTo(2);
    return err.toString(StandardCharsets.UTF_8);
  }
}
