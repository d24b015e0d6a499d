package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests unchanged clients that find the drones at the addresses of real ones by a shim. */
class ShimIT {

  @ParameterizedTest
  @NeedsTool(Tool.PYTHON)
  @ValueSource(
      strings = {
        "djitellopy",
        "djitellopy-swarm",
        "djitellopy-video",
        "easytello",
        "ros-driver",
        "tello-asyncio",
        "tello-drone",
        "tellojs"
      })
  void unchangedClientFliesWhereItsCommandsLead(String client)
      throws IOException, InterruptedException {
    ClientFlight.fly("--shim", client);
  }

  @Test
  @Timeout(240)
  void aJavaProgramFliesToTheAddressOfARealDrone() throws IOException, InterruptedException {
    List<String> command =
        List.of(
            Jvm.java(),
            "-jar",
            ClientFlight.jar(),
            "run",
            "--shim",
            "--headless",
            "--time-factor",
            "max",
            "--",
            Jvm.java(),
            "examples/FirstFlight.java",
            "192.168.10.1",
            "8889");
    Process process = Jvm.process(command).redirectErrorStream(true).start();
    try {
      String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertThat(process.waitFor()).as(printed).isZero();
      assertThat(printed).contains("`land` answered `ok`", "program: exit code 0");
    } finally {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
    }
  }
}
