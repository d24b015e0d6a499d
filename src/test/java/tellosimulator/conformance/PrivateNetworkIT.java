package tellosimulator.conformance;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests unchanged clients in a network in which the drone has the address of a real drone. */
@NeedsTool(Tool.PYTHON)
class PrivateNetworkIT {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "djitellopy",
        "djitellopy-swarm",
        "djitellopy-video",
        "easytello",
        "like-ctello",
        "ros-driver",
        "tello-asyncio",
        "tello-drone",
        "tellojs",
        "tellopy"
      })
  void unchangedClientFliesWhereItsCommandsLead(String client)
      throws IOException, InterruptedException {
    ClientFlight.fly("--private-network", client);
  }

  @Test
  @NeedsTool(Tool.GO)
  void unchangedClientInGoFlies() throws IOException, InterruptedException {
    ClientFlight.fly("--private-network", "gobot");
  }

  @Test
  @NeedsTool(Tool.NAMESPACES)
  void javaProgramFliesToTheAddressOfARealDrone() throws IOException, InterruptedException {
    ClientFlight.flyFirstFlight();
  }

  @Test
  void unchangedClientFliesThroughAProxyOnTheRealPorts() throws IOException, InterruptedException {
    ClientFlight.fly("--private-network", "--proxy", "djitellopy");
  }
}
