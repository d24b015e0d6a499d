package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SimulatedDrone.address;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

class LogLimiterTest {

  private static final Peer OPERATOR = peer("127.0.0.1");
  private static final Peer STRANGER = peer("127.0.0.9");
  private static final Phrase REASON = Phrase.of("because");

  private final List<SimEvent> told = new ArrayList<>();
  private final LogLimiter limiter =
      new LogLimiter(
          new SimListener() {
            @Override
            public void event(SimEvent event) {
              told.add(event);
            }
          });

  @Test
  void everythingThatIsACommandIsTold() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, OPERATOR, "forward 50"));
      limiter.event(
          new SimEvent.CommandRefused(
              SimTime.ZERO, 1, OPERATOR, "forward 50", Reply.MOTOR_STOP, REASON));
    }

    assertThat(told).hasSize(2000);
  }

  @Test
  void oneWhoIsTurnedAwayIsToldOnce() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, STRANGER, "takeoff", REASON));
    }
    limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, peer("127.0.0.8"), "land", REASON));
    limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 2, STRANGER, "takeoff", REASON));

    assertThat(told).hasSizeLessThanOrEqualTo(5).hasSizeGreaterThanOrEqualTo(3);
    assertThat(told).extracting(SimEvent::drone).contains(2);
  }

  @Test
  void ofUnknownTextsAFewAreToldAndTheRestInSums() {
    int sent = 100_000;
    for (int i = 0; i < sent; i++) {
      limiter.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, OPERATOR, "garbage " + i));
    }
    int single = told.size();
    assertThat(single).isBetween(40, 1000);

    long sum = 0;
    while (sum == 0) { // until a token has come back
      limiter.stepped(anything());
      sum =
          told.stream()
              .filter(SimEvent.Omitted.class::isInstance)
              .mapToLong(event -> ((SimEvent.Omitted) event).count())
              .sum();
    }

    assertThat(single + sum).isEqualTo(sent);
    assertThat(told.get(told.size() - 1).words())
        .isEqualTo(
            String.format(java.util.Locale.ROOT, "%,d more from 127.0.0.1 are not shown", sum));
  }

  private static SimSnapshot anything() {
    return new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
        .snapshot();
  }

  private static Peer peer(String host) {
    return new Peer(address(host, 40_000), address("127.0.0.1", 8879));
  }
}
