package tellosimulator.video;

import java.net.InetSocketAddress;
import java.util.function.Supplier;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.WireTap;

/**
 * A port that reports each datagram it sends to a tap.
 *
 * @param drone the drone's number, from 1
 * @param taps supplies the current tap
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
