package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.SteppedDrone;

class SeverityTest {

  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  @Test
  void whatTheDroneIgnoresOrRefusesIsAWarning() {
    drone.send("takeoff");
    assertThat(lastSeverity()).as("ignored before `command`").isEqualTo(Severity.WARNING);

    drone.ask("command");
    drone.ask("forward 50");
    assertThat(lastSeverity()).as("refused on the ground").isEqualTo(Severity.WARNING);
  }

  @Test
  void readsAndSticksAreDetailsAndOtherCommandsInformation() {
    drone.ask("command");
    assertThat(lastSeverity()).isEqualTo(Severity.INFORMATION);
    drone.ask("battery?");
    assertThat(lastSeverity()).as("reply to a read").isEqualTo(Severity.DETAIL);
    drone.send("rc 0 0 0 0");
    assertThat(lastSeverity()).isEqualTo(Severity.DETAIL);
  }

  @Test
  void aLandingThatNobodyCommandedIsAWarningAndACrashAnError() {
    drone.ask("command");
    drone.ask("takeoff");
    drone.advance(16);
    assertThat(drone.events())
        .filteredOn(event -> event.words().startsWith("lands by itself"))
        .singleElement()
        .extracting(SimEvent::severity)
        .isEqualTo(Severity.WARNING);

    drone.ask("takeoff");
    drone.ask("up 150");
    drone.control(new Control.Power(1, false));
    drone.advance(5);
    assertThat(drone.events())
        .filteredOn(event -> event.words().startsWith("crashed into"))
        .singleElement()
        .extracting(SimEvent::severity)
        .isEqualTo(Severity.ERROR);
  }

  private Severity lastSeverity() {
    return drone.events().get(drone.events().size() - 1).severity();
  }

  @Test
  void readsAndSticksOfTheAppAreDetails() {
    drone.send(AppPackets.CONNECT);
    assertThat(lastSeverity()).isEqualTo(Severity.INFORMATION);
    drone.send(AppPackets.SSID);
    assertThat(lastSeverity()).as("reply to a read").isEqualTo(Severity.DETAIL);
    drone.send(AppPackets.STICKS);
    assertThat(lastSeverity()).isEqualTo(Severity.DETAIL);
    drone.send(AppPackets.TAKEOFF);
    assertThat(lastSeverity()).isEqualTo(Severity.INFORMATION);
  }
}
