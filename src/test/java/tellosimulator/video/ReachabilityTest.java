package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Peer;

class ReachabilityTest {

  private static final OperatorEndpoint REMOTE = link("192.168.10.2");
  private static final OperatorEndpoint LOCAL = link("127.0.0.1");

  private static final long SECOND = 1_000_000_000;
  private static final long TENTH = SECOND / 10;

  private final AtomicLong clock = new AtomicLong(-50 * SECOND); // System.nanoTime may be negative
  private final Reachability reachability = new Reachability(clock::get);

  @Test
  void whoTakesVideoGetsItUntilTwoMinutesOfSilence() {
    reachability.heard();
    pass(120 * SECOND);
    assertThat(reachability.rests(REMOTE)).isFalse();

    pass(TENTH);

    assertThat(reachability.rests(REMOTE)).isTrue();
    assertThat(reachability.triesAgain(REMOTE)).isFalse();
    reachability.heard();
    assertThat(reachability.rests(REMOTE)).isFalse();
  }

  @Test
  void whoTakesNothingIsTriedAgainForTenSeconds() {
    reachability.heard();
    int tries = 0;
    for (int i = 0; i < 200; i++) {
      if (!reachability.rests(REMOTE)) {
        tries++;
        reachability.unreachable();
      }
      assertThat(reachability.triesAgain(REMOTE)).as("after %d tenths", i).isEqualTo(i < 100);
      pass(TENTH);
    }

    assertThat(tries).as("at once, and every 1.5 s").isEqualTo(7);
  }

  @Test
  void hisNextDatagramBringsVideoBack() {
    reachability.heard();
    reachability.unreachable();
    assertThat(reachability.rests(REMOTE)).isTrue();

    reachability.heard();

    assertThat(reachability.rests(REMOTE)).isFalse();
    assertThat(reachability.triesAgain(REMOTE)).isFalse();
  }

  @Test
  void nothingRestsForAProgramOnThisMachine() {
    reachability.heard();
    reachability.unreachable();
    pass(1000 * SECOND);

    assertThat(reachability.rests(LOCAL)).isFalse();
    assertThat(reachability.rests(OperatorEndpoint.raw(Optional.empty(), 8890, 11111))).isFalse();
  }

  private void pass(long nanos) {
    clock.addAndGet(nanos);
  }

  private static OperatorEndpoint link(String host) {
    InetSocketAddress drone = address("192.168.10.1", 8889);
    return OperatorEndpoint.raw(Optional.of(new Peer(address(host, 40_000), drone)), 8890, 11111);
  }
}
