package tellosimulator.conformance;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests clients on the simulator's own machine, configured with its address and port. */
@NeedsTool(Tool.PYTHON)
class LoopbackIT {

  @ParameterizedTest(name = "{0}, time factor {1}")
  @CsvSource(
      textBlock =
          """
          djitellopy,    5
          djitellopy,    max
          tello-asyncio, 5
          tellojs,       5
          """)
  void clientFliesWhereItsCommandsLead(String client, String timeFactor)
      throws IOException, InterruptedException {
    ClientFlight.fly("--time-factor", timeFactor, client);
  }
}
