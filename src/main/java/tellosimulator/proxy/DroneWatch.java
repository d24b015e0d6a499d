package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.OptionalLong;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Logs once that a drone does not answer, and once that it answers again. Not thread-safe. */
final class DroneWatch {

  private static final Logger LOG = LoggerFactory.getLogger(DroneWatch.class);

  /**
   * Time without a datagram from the drone, counted from a command, after which the drone counts as
   * not answering [ns]. Decided.
   */
  private static final long PATIENCE = 5_000_000_000L;

  private final InetSocketAddress drone;

  /**
   * The time of the first command since the last datagram from the drone; empty if no command has
   * been sent since then.
   */
  private OptionalLong waiting = OptionalLong.empty();

  private boolean told;

  DroneWatch(InetSocketAddress drone) {
    this.drone = drone;
  }

  /**
   * Called when a command has been sent.
   *
   * @param nanos the time of sending [ns]
   */
  void commanded(long nanos) {
    if (waiting.isEmpty()) {
      waiting = OptionalLong.of(nanos);
    }
  }

  /** Called when a datagram has arrived from the drone. */
  void heard() {
    waiting = OptionalLong.empty();
    if (told) {
      told = false;
      LOG.info("The drone at {} answers again", drone.getAddress().getHostAddress());
    }
  }

  /**
   * Advances the time.
   *
   * @param nanos the new time [ns]
   */
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
