package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.OptionalLong;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Says once when a drone does not answer, and when it does again. For one thread. */
final class DroneWatch {

  private static final Logger LOG = LoggerFactory.getLogger(DroneWatch.class);

  /** How long a command may wait for the first sign of life [ns]. Decided. */
  private static final long PATIENCE = 5_000_000_000L;

  private final InetSocketAddress drone;

  /** When the first command was sent that nothing has come after; empty if there is none. */
  private OptionalLong waiting = OptionalLong.empty();

  private boolean told;

  DroneWatch(InetSocketAddress drone) {
    this.drone = drone;
  }

  /** A command was sent at a moment [ns]. */
  void commanded(long nanos) {
    if (waiting.isEmpty()) {
      waiting = OptionalLong.of(nanos);
    }
  }

  /** Something came from the drone. */
  void heard() {
    waiting = OptionalLong.empty();
    if (told) {
      told = false;
      LOG.info("The drone at {} answers again", drone.getAddress().getHostAddress());
    }
  }

  /** Time passes; now is [ns]. */
  void tick(long nanos) {
    if (!told && waiting.isPresent() && nanos - waiting.getAsLong() >= PATIENCE) {
      told = true;
      LOG.warn(
          "The drone at {}:{} does not answer: switch it on, and join its network",
          drone.getAddress().getHostAddress(),
          drone.getPort());
    }
  }
}
