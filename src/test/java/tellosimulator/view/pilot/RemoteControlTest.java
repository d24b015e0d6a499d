package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;

/** Single commands through the real port. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RemoteControlTest {

  private final FlownWindow window =
      new FlownWindow(SimConfig.DEFAULT.withTimeFactor(new TimeFactor(10)));
  private final RemoteControl remote = new RemoteControl(window.context());

  @AfterEach
  void close() {
    remote.close();
    window.close();
  }

  @Test
  void takingOffSwitchesTheDroneOnFirst() {
    remote.takeOff();

    window.tickUntil(() -> window.phase() == FlightPhase.FLYING);
    assertThat(window.commands()).containsExactly("command", "takeoff");
  }

  @Test
  void whoPressesTwiceTakesOffOnce() {
    remote.takeOff();
    remote.takeOff();

    window.tickUntil(() -> window.phase() == FlightPhase.FLYING);
    assertThat(window.commands()).containsExactly("command", "takeoff");
  }

  @Test
  void whatIsAskedForWhileThePowerIsNotYetOnTakesThePlaceOfTheTakeoff() {
    remote.takeOff();
    remote.ask("emergency");
    window.settle();

    remote.ask("battery?");
    window.tickUntil(() -> window.commands().contains("battery?"));
    assertThat(window.commands()).doesNotContain("takeoff");
  }
}
