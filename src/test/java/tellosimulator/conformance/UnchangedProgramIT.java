package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Programs for real drones, flown by the subcommand {@code run} without one changed character. */
@EnabledOnOs(OS.LINUX)
class UnchangedProgramIT {

  private static final Path PYTHON = Path.of("conformance", ".venv", "bin", "python");

  @Test
  @Timeout(240)
  void aSwarmOfDjitellopyFliesWhereRealDronesAre() throws IOException, InterruptedException {
    if (!Files.isExecutable(PYTHON)) {
      ClientFlight.cannotFly("djitellopy is not installed; see conformance/README.md");
    }
    List<String> command = new ArrayList<>(List.of(ClientFlight.java(), "-jar"));
    command.addAll(List.of(ClientFlight.jar(), "run", "--headless", "--time-factor", "2"));
    command.addAll(List.of("--drones", "3", "--", PYTHON.toString()));
    command.add("examples/swarm_formation.py");
    command.addAll(List.of("192.168.10.11", "192.168.10.12", "192.168.10.13"));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    try {
      String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      int code = process.waitFor();
      if (printed.contains("A private network cannot be made")) {
        ClientFlight.cannotFly(printed);
      }
      assertThat(printed).contains("All have landed.", "in cm: [60, 80, 100]");
      assertThat(code).as(printed).isZero();
    } finally {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
    }
  }
}
