package tellosimulator.proxy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.network.UdpPort;

/**
 * For each place that commands come from a socket towards the drone, so that replies find their way
 * back; the drone sees one host. For one thread.
 */
final class OperatorPorts implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(OperatorPorts.class);

  /** Sockets at a time; beyond that, the one that was silent longest is closed. Decided. */
  private static final int MOST = 64;

  private boolean failureTold;

  private final Map<InetSocketAddress, UdpPort> ports =
      new LinkedHashMap<>(MOST, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<InetSocketAddress, UdpPort> eldest) {
          boolean many = size() > MOST;
          if (many) {
            eldest.getValue().close();
          }
          return many;
        }
      };

  /** Opens a socket. */
  @FunctionalInterface
  interface Opening {
    UdpPort open() throws IOException;
  }

  /**
   * The socket for an operator, which is opened if there is none; empty if there can be none, which
   * is told once until there can be one again.
   */
  Optional<UdpPort> of(InetSocketAddress operator, Opening opening) {
    UdpPort known = ports.get(operator);
    if (known != null) {
      return Optional.of(known);
    }
    try {
      UdpPort opened = opening.open();
      ports.put(operator, opened);
      failureTold = false;
      return Optional.of(opened);
    } catch (IOException e) {
      if (!failureTold) {
        LOG.warn("Commands are lost, because there is no socket for them: {}", e.getMessage());
      }
      failureTold = true;
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    ports.values().forEach(UdpPort::close);
    ports.clear();
  }
}
