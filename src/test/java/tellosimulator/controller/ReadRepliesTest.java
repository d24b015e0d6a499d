package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;

class ReadRepliesTest {

  /** Egyptian Arabic has its own digits, and German a decimal comma. */
  @ParameterizedTest
  @CsvSource({"ar-EG", "de-DE", "tr-TR", "en-US"})
  void theCountryOfTheMachineChangesNoReply(String language) {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag(language));
    try {
      SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
      drone.ask("command");

      assertThat(drone.ask("speed?")).isEqualTo("100.0\r\n");
      assertThat(drone.ask("battery?")).isEqualTo("100\r\n");
      assertThat(drone.ask("sn?")).isEqualTo("0TQSIMUL000001");
      assertThat(drone.ask("attitude?")).isEqualTo("pitch:0;roll:0;yaw:0;\r\n");
      assertThat(drone.ask("acceleration?")).isEqualTo("agx:0.00;agy:0.00;agz:-1000.00;\r\n");
      assertThat(drone.ask("baro?")).matches("-?[0-9]+\\.[0-9]{6}\r\n");
      assertThat(drone.ask("height?")).isEqualTo("0dm\r\n");
      drone.advance(0.1);
      assertThat(drone.stateLines().get(0).text()).contains("tof:10;h:0;bat:100;baro:");
    } finally {
      Locale.setDefault(before);
    }
  }
}
