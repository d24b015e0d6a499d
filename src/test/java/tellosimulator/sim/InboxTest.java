package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimInput.Datagram;

class InboxTest {

  private final Inbox inbox = new Inbox();

  @Test
  void whatComesFirstLeavesFirst() {
    Datagram first = from(1, "a");
    Datagram second = from(2, "b");
    Datagram third = from(1, "c");
    inbox.offer(first, true);
    inbox.offer(second, false);
    inbox.offer(third, true);

    assertThat(inbox.poll()).isSameAs(first);
    assertThat(inbox.poll()).isSameAs(second);
    assertThat(inbox.poll()).isSameAs(third);
    assertThat(inbox.poll()).isNull();
    assertThat(inbox.isEmpty()).isTrue();
  }

  @Test
  void oneSenderFillsOnlyItsPart() {
    int taken = 0;
    while (inbox.offer(from(1, "battery?"), true)) {
      taken++;
    }

    assertThat(taken).isEqualTo(256);
    assertThat(inbox.offer(from(2, "battery?"), true)).isTrue();
    inbox.poll();
    assertThat(inbox.offer(from(1, "battery?"), true)).isTrue();
    assertThat(inbox.offer(from(1, "battery?"), true)).isFalse();
  }

  @Test
  void howeverManyOthersThereAreTheOperatorHasRoom() {
    int taken = 0;
    for (int sender = 1; sender <= 10_000; sender++) {
      taken += inbox.offer(from(sender, "battery?"), false) ? 1 : 0;
    }

    assertThat(taken).isEqualTo(4096 - 1024);
    assertThat(inbox.offer(from(20_000, "land"), true)).isTrue();
  }

  @Test
  void whatTheProgramItselfWantsHasItsTurnAndAlwaysRoom() {
    for (int sender = 1; sender <= 10_000; sender++) {
      inbox.offer(from(sender, "battery?"), true);
    }
    Inbox.Call call = new Inbox.Call("A test failed", () -> {}, () -> {});
    inbox.add(call);

    for (int i = 0; i < 4096; i++) {
      assertThat(inbox.poll()).isInstanceOf(Datagram.class);
    }
    assertThat(inbox.peek()).isSameAs(call);
    assertThat(inbox.poll()).isSameAs(call);
    assertThat(inbox.isEmpty()).isTrue();
  }

  private static Datagram from(int port, String text) {
    Peer peer = new Peer(address("127.0.0.1", port), address("127.0.0.1", 8879));
    return new Datagram(1, peer, WireText.encode(text));
  }
}
