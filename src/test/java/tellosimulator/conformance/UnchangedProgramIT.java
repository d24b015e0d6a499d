package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests programs for real drones, flown unchanged by the subcommand {@code run}. */
@NeedsTool({Tool.NAMESPACES, Tool.PYTHON_CLIENTS})
class UnchangedProgramIT {

  private static final Path PYTHON = Path.of("conformance", ".venv", "bin", "python");

  @TempDir private Path temporary;

  @Test
  @Timeout(240)
  void aSwarmOfDjitellopyFliesWhereRealDronesAre() throws IOException, InterruptedException {
    List<String> words = new ArrayList<>(List.of("--drones", "3", "--", PYTHON.toString()));
    words.add("examples/swarm_formation.py");
    words.addAll(List.of("192.168.10.11", "192.168.10.12", "192.168.10.13"));

    assertThat(run(words)).contains("All have landed.", "in cm: [60, 80, 100]");
  }

  @Test
  @Timeout(240)
  void theExampleOfDjitellopyItselfFlies() throws IOException, InterruptedException {
    Path program = Files.writeString(temporary.resolve("example.py"), exampleOfDjitellopy());

    String printed = run(List.of("--", PYTHON.toString(), program.toString()));

    assertThat(printed)
        .contains("`left 100` answered `ok`")
        .contains("`ccw 90` answered `ok`")
        .contains("`forward 100` answered `ok`")
        .contains("`land` answered `ok`");
  }

  private static String exampleOfDjitellopy() throws IOException {
    try (Stream<Path> files =
        Files.find(PYTHON.getParent().resolveSibling("lib"), 4, UnchangedProgramIT::tells)) {
      String description = Files.readString(files.findFirst().orElseThrow());
      return description.replaceFirst("(?s).*?```python\n(.*?)```.*", "$1");
    }
  }

  private static boolean tells(Path file, BasicFileAttributes attributes) {
    return file.endsWith("METADATA") && file.toString().contains("djitellopy-");
  }

  /** Runs a program with the subcommand, and returns the output of both. */
  private static String run(List<String> words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(Jvm.java(), "-jar"));
    command.addAll(List.of(ClientFlight.jar(), "run", "--headless", "--time-factor", "2"));
    command.addAll(words);
    Process process = Jvm.process(command).redirectErrorStream(true).start();
    try {
      String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      int code = process.waitFor();
      assertThat(code).as(printed).isZero();
      return printed;
    } finally {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
    }
  }
}
