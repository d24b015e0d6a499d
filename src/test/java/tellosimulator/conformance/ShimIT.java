package tellosimulator.conformance;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests unchanged clients that find the drones at the addresses of real ones with a shim. */
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
  @Tag("process")
  void javaProgramFliesToTheAddressOfARealDrone() throws IOException, InterruptedException {
    ClientFlight.flyFirstFlight("--shim");
  }
}
