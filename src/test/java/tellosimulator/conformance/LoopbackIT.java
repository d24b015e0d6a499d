package tellosimulator.conformance;

import java.io.IOException;
import org.junit.jupiter.api.Test;
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
          tellopy,       1
          tellopy-0.6,   1
          like-ctello,   1
          """)
  void clientFliesWhereItsCommandsLead(String client, String timeFactor)
      throws IOException, InterruptedException {
    ClientFlight.fly("--time-factor", timeFactor, client);
  }

  @Test
  @NeedsTool(Tool.GO)
  void clientInGoFlies() throws IOException, InterruptedException {
    ClientFlight.fly("smerrony");
  }

  @Test
  @NeedsTool(Tool.CARGO)
  void clientInRustFlies() throws IOException, InterruptedException {
    ClientFlight.fly("rust-tello");
  }
}
