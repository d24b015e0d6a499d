package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.SteppedDrone;

/** Notifies the watch of the events of a simulated drone. */
class PaceWatchTest {

  private final AtomicInteger notified = new AtomicInteger();
  private final PaceWatch watch = new PaceWatch(notified::incrementAndGet);
  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  @Test
  void aProgramThatWaitsForEachReplyIsPatient() {
    drone.ask("command");
    drone.ask("takeoff");
    drone.ask("battery?");
    drone.ask("flip x"); // refused
    drone.ask("land");

    assertThat(impatient()).isFalse();
    assertThat(notified).hasValue(0);
  }

  @Test
  void aCommandBeforeTheReplyIsImpatient() {
    drone.ask("command");
    drone.send("takeoff");
    drone.send("battery?");
    drone.send("battery?");

    assertThat(impatient()).isTrue();
    assertThat(notified).hasValue(1);
  }

  @Test
  void rcHasNoReplyToWaitFor() {
    drone.ask("command");
    drone.send("rc 0 10 0 0");

    assertThat(impatient()).isTrue();
  }

  @Test
  void theAppIsAnsweredBeforeItsOrdersAreCarriedOut() {
    drone.send(AppPackets.CONNECT);
    drone.send(AppPackets.TAKEOFF);

    assertThat(impatient()).isTrue();
  }

  private boolean impatient() {
    watch.activate();
    drone.events().forEach(watch::event);
    return watch.impatient();
  }
}
