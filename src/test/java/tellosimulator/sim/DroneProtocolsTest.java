package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;

class DroneProtocolsTest {

  @ParameterizedTest
  @ValueSource(strings = {"\u00cc\u0018\u0001\u00b9", "conn_req:\u0096\u0017", "\u00cc"})
  void theAppIsNotHeardWhileTheDroneSpeaksText(String bytes) {
    SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
    drone.ask("command");
    drone.ask("takeoff");

    drone.send(bytes);

    assertThat(drone.replies()).hasSize(2);
    assertThat(drone.link().app()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "conn", "conn_re", "con\u00cc"})
  void whatOnlyResemblesTheAppsProtocolIsAText(String text) {
    SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
    drone.ask("command");

    assertThat(drone.ask(text)).isEqualTo("unknown command: " + text);
  }
}
