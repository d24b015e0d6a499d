package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.testing.Jvm;

/** The same seed and the same commands give the same flight, to the last bit. */
@Tag("process")
@Tag("slow")
class DeterminismTest {

  private static final String SEED = "7";

  @ParameterizedTest
  @ValueSource(strings = {"stepped", "1", "20", "max"})
  void everyPaceInAProcessOfItsOwnGivesTheSameTrace(String pace) throws Exception {
    assertThat(traceOf(Path.of(System.getProperty("java.home")), pace)).isEqualTo(expected(pace));
  }

  @ParameterizedTest
  @ValueSource(strings = {"stepped", "20"})
  void anotherJdkGivesTheSameTrace(String pace) throws Exception {
    Optional<Path> other = otherJdk();
    if (!"true".equals(System.getenv("CI"))) {
      assumeTrue(other.isPresent(), "there is no other JDK beside this one");
    }
    assertThat(other).as("a JDK of another version beside this one").isPresent();

    assertThat(traceOf(other.get(), pace)).isEqualTo(expected(pace));
  }

  @Test
  void anotherSeedGivesAnotherTrace() throws Exception {
    assertThat(TraceProgram.trace("stepped", 8)).isNotEqualTo(expected("stepped"));
  }

  /**
   * Returns the expected hash. At unlimited speed, commands are handled later than by the clock;
   * all other paces are equal.
   */
  private static String expected(String pace) throws Exception {
    String stepped = pace.equals("max") ? "stepped-max" : "stepped";
    return TraceProgram.trace(stepped, Long.parseLong(SEED));
  }

  private static String traceOf(Path javaHome, String pace)
      throws IOException, InterruptedException {
    List<String> command = Jvm.commandOf(TraceProgram.class, pace, SEED);
    command.set(0, Jvm.java(javaHome));
    Process process = Jvm.process(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    String output =
        new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
    assertThat(process.waitFor()).as("exit code of %s", javaHome).isZero();
    return output;
  }

  /** Finds a JDK 17 or newer of another feature version, in the same folder as the running one. */
  private static Optional<Path> otherJdk() throws IOException {
    Path home = Path.of(System.getProperty("java.home")).toRealPath();
    try (Stream<Path> neighbors = Files.list(home.getParent())) {
      return neighbors
          .filter(Files::isDirectory)
          .filter(candidate -> Files.isExecutable(candidate.resolve("bin").resolve("java")))
          .filter(candidate -> isUsable(candidate) && feature(candidate) != feature(home))
          .sorted()
          .findFirst();
    }
  }

  private static boolean isUsable(Path home) {
    return feature(home) >= 17;
  }

  /** Returns the feature version in a JDK's {@code release} file; 0 without one. */
  private static int feature(Path home) {
    try {
      List<String> lines = Files.readAllLines(home.resolve("release"));
      return lines.stream()
          .filter(line -> line.startsWith("JAVA_VERSION="))
          .map(line -> line.replaceAll("[^0-9.]", "").replaceAll("\\..*", ""))
          .mapToInt(Integer::parseInt)
          .findFirst()
          .orElse(0);
    } catch (IOException e) {
      return 0;
    }
  }
}
