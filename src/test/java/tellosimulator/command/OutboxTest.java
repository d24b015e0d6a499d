package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.command.HandlerFixture.OPERATOR;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.time.SimTime;

class OutboxTest {

  private final List<String> sent = new ArrayList<>();
  private final Deque<Double> delays = new ArrayDeque<>();
  private final Outbox outbox = new Outbox((peer, text) -> sent.add(text), delays::remove);

  @Test
  void anImmediateReplyLeavesWhenItsDelayIsOver() {
    delays.add(0.040);
    outbox.flush(at(1));
    outbox.add(OPERATOR, "76\r\n", at(1));

    outbox.flush(at(1.035));
    assertThat(sent).isEmpty();
    assertThat(outbox.isEmpty()).isFalse();

    outbox.flush(at(1.040));
    assertThat(sent).containsExactly("76\r\n");
    assertThat(outbox.isEmpty()).isTrue();
  }

  @Test
  void aLateReplyLeavesAtOnce() {
    outbox.flush(at(5));
    outbox.add(OPERATOR, "ok", at(1));
    outbox.flush(at(5));

    assertThat(sent).containsExactly("ok");
  }

  @Test
  void repliesNeverOvertakeEachOther() {
    delays.add(0.050);
    delays.add(0.030);
    outbox.flush(at(1));
    outbox.add(OPERATOR, "first", at(1));
    outbox.add(OPERATOR, "second", at(1));
    outbox.flush(at(1.005));
    outbox.add(OPERATOR, "late", at(0));

    outbox.flush(at(1.045));
    assertThat(sent).isEmpty();

    outbox.flush(at(1.050));
    assertThat(sent).containsExactly("first", "second", "late");
  }

  @Test
  void whatIsClearedIsNeverSent() {
    delays.add(0.0);
    outbox.add(OPERATOR, "ok", at(0));
    outbox.clear();
    outbox.flush(at(9));

    assertThat(sent).isEmpty();
    assertThat(outbox.isEmpty()).isTrue();
  }

  @Test
  void ofTooManyForOnePeerTheOldestIsDropped() {
    Outbox still = new Outbox((peer, text) -> sent.add(text), () -> 1);
    still.add(peer(1), "of another", at(0));
    for (int i = 0; i < Outbox.MOST_FOR_PEER + 2; i++) {
      still.add(OPERATOR, "reply " + i, at(0));
    }

    assertThat(still.hasDropped()).isTrue();
    assertThat(still.takeDropped()).isEqualTo(2);
    assertThat(still.hasDropped()).isFalse();
    still.flush(at(1));
    assertThat(sent).hasSize(Outbox.MOST_FOR_PEER + 1).startsWith("of another", "reply 2");
    assertThat(still.isEmpty()).isTrue();
  }

  @Test
  void ofTooManyInAllTheOldestIsDropped() {
    Outbox still = new Outbox((peer, text) -> sent.add(text), () -> 1);
    for (int i = 0; i < Outbox.MOST + 3; i++) {
      still.add(peer(i), "reply " + i, at(0));
    }

    assertThat(still.takeDropped()).isEqualTo(3);
    still.flush(at(1));
    assertThat(sent).hasSize(Outbox.MOST).startsWith("reply 3");
  }

  @Test
  void whatHasLeftMakesRoom() {
    Outbox still = new Outbox((peer, text) -> sent.add(text), () -> 1);
    for (int round = 0; round < 3; round++) {
      still.flush(at(10 * round));
      for (int i = 0; i < Outbox.MOST_FOR_PEER; i++) {
        still.add(OPERATOR, "reply", at(10 * round));
      }
      still.flush(at(10 * round + 1));
    }

    assertThat(still.hasDropped()).isFalse();
    assertThat(sent).hasSize(3 * Outbox.MOST_FOR_PEER);
  }

  private static Peer peer(int number) {
    return HandlerFixture.peer(1, 10_000 + number);
  }

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
