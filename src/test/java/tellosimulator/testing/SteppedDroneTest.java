package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.SimConfig;

class SteppedDroneTest {

  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  @Test
  void repliesThatNeedNoTimeAreThereAtOnce() {
    drone.send("command");

    assertThat(drone.replies()).extracting(SteppedDrone.Sent::text).containsExactly("ok");
    assertThat(drone.seconds()).isZero();
  }

  @Test
  void askLetsTimePassUntilTheReply() {
    drone.ask("command");

    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    assertThat(drone.state().motion().position().z()).isCloseTo(0.30, within(0.01));
    assertThat(drone.seconds()).isGreaterThan(1);
  }

  @Test
  void stateLinesGoToTheOperatorsHost() {
    drone.ask("command");
    drone.advance(1);

    assertThat(drone.stateLines()).hasSizeBetween(10, 11);
    assertThat(drone.stateLines().get(0).to())
        .isEqualTo(SteppedDrone.address("192.168.10.2", 8890));
    assertThat(drone.stateLines().get(0).text()).startsWith("mid:-2;").endsWith("\r\n");
  }

  @Test
  void repliesGoToTheFixedPortOfTheClientsHost() {
    SteppedDrone fixed = SteppedDrone.withReplyPort(SimConfig.DEFAULT, 8889);

    fixed.ask("command");

    assertThat(fixed.replies().get(0).to()).isEqualTo(SteppedDrone.address("192.168.10.2", 8889));
  }
}
