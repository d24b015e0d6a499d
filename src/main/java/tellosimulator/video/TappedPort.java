package tellosimulator.video;

import java.net.InetSocketAddress;
import java.util.function.Supplier;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.WireTap;

/**
 * A port whose datagrams somebody sees as they leave it.
 *
 * @param drone its number, from 1
 * @param taps who sees them
 */
record TappedPort(int drone, DatagramPort port, Supplier<WireTap> taps) implements DatagramPort {

  @Override
  public InetSocketAddress address() {
    return port.address();
  }

  @Override
  public void send(byte[] bytes, InetSocketAddress to) {
    taps.get().sent(drone, WireTap.Kind.VIDEO, port.address(), to, bytes);
    port.send(bytes, to);
  }

  @Override
  public void close() {
    port.close();
  }
}
