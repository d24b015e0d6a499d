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
 * Manages the sockets towards the drone, one for each source of commands, so that replies can be
 * routed back. The drone still sees a single host. Not thread-safe.
 */
final class OperatorPorts implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(OperatorPorts.class);

  /**
   * Maximum number of sockets. When it is exceeded, the socket that has been idle longest is
   * closed. Decided.
   */
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
   * Returns the socket for an operator, opening it if necessary; empty if it cannot be opened.
   * After a failure has been logged, further failures are not logged until a socket has been opened
   * successfully.
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
