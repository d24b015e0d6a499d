package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkDirection;
import tellosimulator.testing.InMemoryPort;

class DatagramSenderTest {

  private static final InetSocketAddress CLIENT = address("192.168.10.2", 40_000);

  private final InMemoryPort first = new InMemoryPort(address("192.168.10.1", 8889));
  private final InMemoryPort second = new InMemoryPort(address("127.0.0.1", 8889));
  private final Ports ports = new Ports(List.of(first, second));

  @Test
  void aReplyLeavesFromTheAddressThatWasCommanded() {
    DatagramSender sender = new DatagramSender(ports, OptionalInt.empty());

    sender.send(LinkDatagram.reply(new Peer(CLIENT, second.address()), WireText.encode("ok")));

    assertThat(second.takeSent()).containsExactly(new InMemoryPort.Sent(CLIENT, "ok"));
    assertThat(first.takeSent()).isEmpty();
  }

  @Test
  void aFixedReplyPortIsOfTheSendersHost() {
    DatagramSender sender = new DatagramSender(ports, OptionalInt.of(8889));

    sender.send(LinkDatagram.reply(new Peer(CLIENT, first.address()), WireText.encode("76\r\n")));

    assertThat(first.takeSent())
        .containsExactly(new InMemoryPort.Sent(address("192.168.10.2", 8889), "76\r\n"));
  }

  @Test
  void bytesAbove127ComeBackAsTheyCame() {
    DatagramSender sender = new DatagramSender(ports, OptionalInt.empty());

    sender.send(
        LinkDatagram.reply(
            new Peer(CLIENT, first.address()), WireText.encode("unknown command: \u00ff\0")));

    assertThat(first.takeSent())
        .containsExactly(new InMemoryPort.Sent(CLIENT, "unknown command: \u00ff\0"));
  }

  @Test
  void aReplyThroughAPortThatIsGoneIsLost() {
    DatagramSender sender = new DatagramSender(ports, OptionalInt.empty());

    sender.send(
        LinkDatagram.reply(new Peer(CLIENT, address("127.0.0.9", 8889)), WireText.encode("ok")));

    assertThat(first.takeSent()).isEmpty();
    assertThat(second.takeSent()).isEmpty();
  }

  @Test
  void aStateLineGoesToTheStatePortEvenWithAFixedReplyPort() {
    DatagramSender sender = new DatagramSender(ports, OptionalInt.of(8889));
    byte[] line = WireText.encode("pitch:0;\r\n");
    InetSocketAddress statePort = address("192.168.10.2", 8890);

    sender.send(
        new LinkDatagram(LinkDirection.STATE, new Peer(statePort, first.address()), line, false));

    assertThat(first.takeSent()).containsExactly(new InMemoryPort.Sent(statePort, "pitch:0;\r\n"));
  }
}
