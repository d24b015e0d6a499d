package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

class LogLimiterTest {

  private static final long SECOND = 1_000_000_000;
  private static final Peer OPERATOR = peer("127.0.0.1");
  private static final Peer STRANGER = peer("127.0.0.9");
  private static final Phrase REASON = Phrase.of("because");

  private long nanos;
  private final List<SimEvent> told = new ArrayList<>();
  private final LogLimiter limiter =
      new LogLimiter(
          new SimListener() {
            @Override
            public void event(SimEvent event) {
              told.add(event);
            }
          },
          () -> nanos);

  @Test
  void everythingThatIsACommandIsTold() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(
          new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(i, OPERATOR, "forward 50")));
      limiter.event(
          new SimEvent.CommandRefused(
              SimTime.ZERO, 1, new Request(i, OPERATOR, "forward 50"), Reply.MOTOR_STOP, REASON));
    }

    assertThat(told).hasSize(2000);
  }

  @Test
  void whatTheAppAsksIsACommandAndWhatIsTurnedAwayIsNot() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(
          new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(i, OPERATOR, "ssid? (app)")));
      limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, STRANGER, "land (app)", REASON));
    }

    assertThat(told).hasSize(1001);
  }

  @Test
  void oneWhoIsTurnedAwayIsToldOnce() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, STRANGER, "takeoff", REASON));
    }
    limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, peer("127.0.0.8"), "land", REASON));
    limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 2, STRANGER, "takeoff", REASON));

    assertThat(told).hasSize(3);
    assertThat(told)
        .extracting(event -> ((SimEvent.ForDrone) event).drone())
        .containsExactly(1, 1, 2);
  }

  @Test
  void aFloodFromMoreHostsThanAreRememberedIsToldInSums() {
    int hosts = 1000;
    for (int round = 0; round < 10; round++) {
      for (int i = 0; i < hosts; i++) {
        Peer sender = peer("10.0." + i / 250 + "." + (i % 250 + 1));
        limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, sender, "takeoff", REASON));
      }
    }
    // the first event of each of 256 hosts, and the first of all others together
    assertThat(told).hasSize(257);

    nanos += SECOND;
    limiter.stepped(anything());

    List<SimEvent> sums = told.subList(257, told.size());
    assertThat(sums).hasSize(257);
    assertThat(sums.get(256).words())
        // 10 from each of 744 hosts, one of them shown
        .isEqualTo("7,439 more from many hosts are not shown");
  }

  @Test
  void hostsThatHaveBeenSilentForLongMakeRoomForOthers() {
    for (int i = 0; i < 256; i++) {
      limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, peer("10.0.0." + i), "land", REASON));
    }
    nanos += 60 * SECOND;
    for (int i = 0; i < 3; i++) {
      limiter.event(new SimEvent.TurnedAway(SimTime.ZERO, 1, peer("10.0.1." + i), "land", REASON));
    }

    assertThat(told).hasSize(256 + 3);
  }

  @Test
  void repliesThatAreDroppedAreToldInSums() {
    for (int i = 0; i < 1000; i++) {
      limiter.event(new SimEvent.WaitingDropped(SimTime.ZERO, 1, 2));
    }
    limiter.stepped(anything());
    assertThat(told).containsExactly(new SimEvent.WaitingDropped(SimTime.ZERO, 1, 2));

    nanos += SECOND;
    limiter.event(new SimEvent.WaitingDropped(SimTime.ZERO, 1, 2));
    limiter.event(new SimEvent.WaitingDropped(SimTime.ZERO, 1, 3));
    nanos += SECOND;
    limiter.stepped(anything());

    assertThat(told.subList(1, told.size()))
        .containsExactly(
            new SimEvent.WaitingDropped(SimTime.ZERO, 1, 2000),
            new SimEvent.WaitingDropped(SimTime.ZERO, 1, 3));
  }

  @Test
  void ofUnknownTextsAFewAreToldAndTheRestInSums() {
    int sent = 100_000;
    for (int i = 0; i < sent; i++) {
      limiter.event(
          new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(i, OPERATOR, "garbage " + i)));
    }
    assertThat(told).hasSize(40);

    nanos += SECOND;
    limiter.stepped(anything());

    assertThat(told).hasSize(41);
    assertThat(told.get(40).words()).isEqualTo("99,960 more from 127.0.0.1 are not shown");
  }

  private static SimSnapshot anything() {
    return new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of()).snapshot();
  }

  private static Peer peer(String host) {
    return new Peer(address(host, 40_000), address("127.0.0.1", 8879));
  }
}
