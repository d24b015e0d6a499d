package tellosimulator.conformance;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests clients that receive the drone's video, in real time. */
@NeedsTool(Tool.PYTHON)
class VideoIT {

  @ParameterizedTest
  @ValueSource(strings = {"djitellopy-video", "find_marker"})
  void clientSeesWhatIsInFrontOfTheDrone(String client) throws IOException, InterruptedException {
    ClientFlight.fly(client);
  }
}
