package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/**
 * Runs the tests in {@code examples/testing/pytest} with the runnable jar and the pytest plugin.
 */
@NeedsTool(Tool.PYTHON_CLIENTS)
class PytestIT {

  private static final Path TESTS = Path.of("examples", "testing", "pytest");

  private static final String PLUGIN = "tello_simulator.pytest_plugin";

  private record Run(int exitCode, String output) {}

  @Test
  @Timeout(180)
  void theExampleIsGreen() throws IOException, InterruptedException {
    Run run = run("-m", "pytest", "-v", "-p", PLUGIN, "-p", "no:cacheprovider", TESTS.toString());

    assertThat(run.exitCode).as(run.output).isZero();
    assertThat(run.output)
        .contains("test_the_square_ends_where_it_began PASSED")
        .containsPattern("[6-9] passed");
  }

  @Test
  @Timeout(180)
  void aFailureTellsWhatTheDronesDid() throws IOException, InterruptedException {
    Path folder = Files.createDirectories(Path.of("target", "pytest-red"));
    String text = Files.readString(TESTS.resolve("test_square.py"));
    Files.writeString(
        folder.resolve("test_square.py"), text.replace("\"cw 90\"] * 4", "\"cw 80\"] * 4"));

    Run run =
        run(
            "-m",
            "pytest",
            "-p",
            PLUGIN,
            "-k",
            "square_ends",
            "-p",
            "no:cacheprovider",
            folder.toString());

    assertThat(run.exitCode).as(run.output).isEqualTo(1);
    assertThat(run.output).contains("1 failed", "last command to drone 1:", "`cw 80` → `ok`");
  }

  private static Run run(String... arguments) throws IOException, InterruptedException {
    ProcessBuilder builder = Tool.PYTHON_CLIENTS.command(arguments).redirectErrorStream(true);
    builder.environment().put("TELLO_SIMULATOR_JAR", ClientFlight.jar());
    builder.environment().put("TELLO_SIMULATOR_JAVA", Jvm.java());
    builder.environment().put("PYTHONPATH", Path.of("python", "src").toAbsolutePath().toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    Process process = builder.start();
    try {
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return new Run(process.waitFor(), output);
    } finally {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
    }
  }
}
