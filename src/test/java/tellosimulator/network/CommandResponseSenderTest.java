package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.testing.InMemoryPort;

class CommandResponseSenderTest {

  private static final InetSocketAddress CLIENT = address("192.168.10.2", 40_000);

  private final InMemoryPort first = new InMemoryPort(address("192.168.10.1", 8889));
  private final InMemoryPort second = new InMemoryPort(address("127.0.0.1", 8889));
  private final Ports ports = new Ports(List.of(first, second));

  @Test
  void aReplyLeavesFromTheAddressThatWasCommanded() {
    CommandResponseSender sender = new CommandResponseSender(ports, OptionalInt.empty());

    sender.reply(new Peer(CLIENT, second.address()), "ok");

    assertThat(second.takeSent()).containsExactly(new InMemoryPort.Sent(CLIENT, "ok"));
    assertThat(first.takeSent()).isEmpty();
  }

  @Test
  void aFixedReplyPortIsOfTheSendersHost() {
    CommandResponseSender sender = new CommandResponseSender(ports, OptionalInt.of(8889));

    sender.reply(new Peer(CLIENT, first.address()), "76\r\n");

    assertThat(first.takeSent())
        .containsExactly(new InMemoryPort.Sent(address("192.168.10.2", 8889), "76\r\n"));
  }

  @Test
  void bytesAbove127ComeBackAsTheyCame() {
    CommandResponseSender sender = new CommandResponseSender(ports, OptionalInt.empty());

    sender.reply(new Peer(CLIENT, first.address()), "unknown command: \u00ff\0");

    assertThat(first.takeSent())
        .containsExactly(new InMemoryPort.Sent(CLIENT, "unknown command: \u00ff\0"));
  }

  @Test
  void aReplyThroughAPortThatIsGoneIsLost() {
    CommandResponseSender sender = new CommandResponseSender(ports, OptionalInt.empty());

    sender.reply(new Peer(CLIENT, address("127.0.0.9", 8889)), "ok");

    assertThat(first.takeSent()).isEmpty();
    assertThat(second.takeSent()).isEmpty();
  }
}
