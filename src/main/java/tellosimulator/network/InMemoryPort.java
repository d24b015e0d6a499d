package tellosimulator.network;

import java.net.InetSocketAddress;
import java.nio.channels.ClosedChannelException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import tellosimulator.command.WireText;

/** A port without a network, for tests and benchmarks. For any thread. */
public final class InMemoryPort implements DatagramPort {

  /**
   * A datagram that was sent.
   *
   * @param text its bytes as ISO-8859-1
   */
  public record Sent(InetSocketAddress to, String text) {}

  private final InetSocketAddress address;
  private final BlockingQueue<Optional<Received>> incoming = new LinkedBlockingQueue<>();
  private final List<Sent> outgoing = new ArrayList<>();

  public InMemoryPort(InetSocketAddress address) {
    this.address = address;
  }

  /** Lets a datagram arrive. */
  public void deliver(InetSocketAddress sender, String text) {
    incoming.add(Optional.of(new Received(sender, text)));
  }

  /** What was sent since this was asked last. */
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
  public Received receive() throws ClosedChannelException {
    try {
      Optional<Received> received = incoming.take();
      if (received.isPresent()) {
        return received.get();
      }
      close();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw new ClosedChannelException();
  }

  @Override
  public synchronized void send(byte[] bytes, InetSocketAddress to) {
    outgoing.add(new Sent(to, WireText.decode(bytes, bytes.length)));
  }

  @Override
  public void close() {
    incoming.add(Optional.empty());
  }
}
