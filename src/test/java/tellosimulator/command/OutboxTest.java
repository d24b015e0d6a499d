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

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
