package tellosimulator.testing;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.WireText;
import tellosimulator.network.DatagramPort;

/** A port without a network, which stores sent datagrams. Thread-safe. */
public final class InMemoryPort implements DatagramPort {

  /**
   * A datagram that was sent.
   *
   * @param text its bytes as ISO-8859-1
   */
  public record Sent(InetSocketAddress to, String text) {}

  private final InetSocketAddress address;
  private final List<Sent> outgoing = new ArrayList<>();

  public InMemoryPort(InetSocketAddress address) {
    this.address = address;
  }

  /** Returns and removes all datagrams sent so far. */
  public synchronized List<Sent> takeSent() {
    List<Sent> sent = List.copyOf(outgoing);
    outgoing.clear();
    return sent;
  }

  @Override
  public InetSocketAddress address() {
    return address;
  }

  @Override
  public synchronized void send(byte[] bytes, InetSocketAddress to) {
    outgoing.add(new Sent(to, WireText.decode(bytes)));
  }

  @Override
  public void close() {}
}
